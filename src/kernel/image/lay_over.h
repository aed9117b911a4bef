#pragma once

#include <cstdint>

namespace relievo {

/// What is seen of `below` through `above` of this opacity (255: nothing), rounded.
inline uint8_t lay_over(int above, int below, int alpha) {
  return static_cast<uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// A colour of this opacity as seen on white paper.
inline uint8_t on_paper(int colour, int alpha) { return lay_over(colour, 255, alpha); }

}  // namespace relievo
