#include "kernel/image/compose.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace relievo {

void lay_over(uint8_t* below, const uint8_t* above, double opacity) {
  const double a = opacity * above[3] / 255;
  if (a <= 0) return;
  const double b = below[3] / 255.0 * (1 - a);
  for (int k = 0; k < 3; ++k)
    below[k] = static_cast<uint8_t>(std::lround((a * above[k] + b * below[k]) / (a + b)));
  below[3] = static_cast<uint8_t>(std::lround(255 * (a + b)));
}

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
