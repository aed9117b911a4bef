#pragma once

#include <pugixml.hpp>
#include <string>

namespace relievo {

/// Makes the document under `root` safe to paint (see PaintableSvg), gives it this size, and
/// returns its text.
std::string paintable_text(pugi::xml_node root, double px_width, double px_height);

}  // namespace relievo
