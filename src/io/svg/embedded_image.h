#pragma once

#include <cstdint>
#include <optional>
#include <pugixml.hpp>

namespace relievo {

struct EmbeddedSize {
  uint32_t width = 0;
  uint32_t height = 0;
};

/// Size of the PNG file that an <image> carries in a data: reference, from its header alone;
/// nothing for any other content, and for references to elsewhere.
std::optional<EmbeddedSize> embedded_png_size(const pugi::xml_node& image);

}  // namespace relievo
