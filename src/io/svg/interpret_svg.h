#pragma once

#include "io/svg/annotated_parts.h"
#include "io/svg/read_svg.h"

namespace relievo {

/// A drawing with what it means.
struct SvgInterpretation {
  SvgImport import;
  std::vector<pugi::xml_node> note_elements;  ///< that must not be painted
};

/// The second half of read_svg: from flattened shapes to a scene.
Result<SvgInterpretation> interpret_svg(const SvgDrawing& drawing, const SvgOptions& options);

}  // namespace relievo
