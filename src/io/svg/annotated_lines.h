#pragma once

#include <vector>

#include "io/svg/annotated_parts.h"
#include "io/svg/svg_drawing.h"
#include "relievo/scene.h"

namespace relievo {

struct AnnotatedJoins {
  std::vector<Join> joins;
  std::vector<pugi::xml_node> elements;  ///< that must not be painted
};

/// Joins of the drawing. A marked line is a join of the part it lies in (or data-upper) to
/// data-lower, which may lie in front of it (turn_joins_from_behind), or else to the nearest part
/// behind that contains most of it. With `layers`, a stroke without a fill that runs along the
/// outline of its part, over a part behind, is one too. Fails with bad_input where a name is
/// unknown or the upper part is not said, with contradiction where the line lies over no part
/// behind.
Result<AnnotatedJoins> annotated_joins(const SvgDrawing& drawing,
                                       const std::vector<AnnotatedPart>& parts, bool layers);

struct AnnotatedCues {
  std::vector<Cue> cues;
  std::vector<pugi::xml_node> elements;  ///< that must not be painted
};

/// Cues of the drawing: each subpath of a marked line is one, of the part it lies in or data-part.
/// Fails with bad_input where the part is unknown or not said, or data-cue or data-value is
/// unsound.
Result<AnnotatedCues> annotated_cues(const SvgDrawing& drawing,
                                     const std::vector<AnnotatedPart>& parts);

}  // namespace relievo
