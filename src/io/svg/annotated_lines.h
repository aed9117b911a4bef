#pragma once

#include <pugixml.hpp>
#include <vector>

#include "io/svg/annotated_parts.h"
#include "io/svg/svg_drawing.h"
#include "relievo/scene.h"

namespace relievo {

/// Adds the joins of the drawing, and the elements that draw them to `elements`. A marked line
/// joins the part that holds it (or data-upper) to data-lower, which may lie in front of it (see
/// turn_joins_from_behind), or else to the nearest part behind that contains most of it. With
/// `layers`, a stroke without a fill that runs along the outline of its part, over a part behind,
/// is a join too. Errors: `bad_input` for unknown or missing names, `contradiction` for a line over
/// no part behind.
Status add_annotated_joins(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                           bool layers, std::vector<Join>& joins,
                           std::vector<pugi::xml_node>& elements);

/// Adds the cues of the drawing, and the elements that draw them to `elements`: each subpath of a
/// marked line is a cue of the part that holds it or of data-part. Errors: `bad_input` for an
/// unknown or missing part, and for an unsound data-cue or data-value.
Status add_annotated_cues(const SvgDrawing& drawing, const std::vector<AnnotatedPart>& parts,
                          std::vector<Cue>& cues, std::vector<pugi::xml_node>& elements);

}  // namespace relievo
