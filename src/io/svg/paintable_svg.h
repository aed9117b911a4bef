#pragma once

#include <string>
#include <vector>

#include "io/svg/svg_document.h"

namespace relievo {

/// The text of a PaintableSvg whose root has this size, px. The document becomes it; `notes` are
/// elements of it that are left out.
std::string paintable_text(SvgDocument& document, double width, double height,
                           const std::vector<pugi::xml_node>& notes);

}  // namespace relievo
