#include "kernel/image/compose.h"

#include <algorithm>
#include <cstdint>

namespace relievo {

bool is_light_on_nothing(const Image8& rgba) {
  int64_t opaque = 0;
  int64_t light = 0;
  for (size_t i = 0; i < rgba.pixels.size(); i += 4) {
    if (rgba.pixels[i + 3] < 128) continue;
    ++opaque;
    light += std::min({rgba.pixels[i], rgba.pixels[i + 1], rgba.pixels[i + 2]}) > 200 ? 1 : 0;
  }
  const auto pixels = static_cast<int64_t>(rgba.pixels.size() / 4);
  return opaque < pixels / 4 && light > opaque * 9 / 10;
}

}  // namespace relievo
