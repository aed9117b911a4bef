#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace relievo {

/// The eight pixels around one that are not 0: bits clockwise from the one above. The pixel lies
/// inside an image of one channel whose rows are `stride` apart.
inline uint32_t ring_around(const uint8_t* pixel, int stride) {
  const std::array<int, 8> offsets = {-stride, 1 - stride, 1,  1 + stride,
                                      stride,  stride - 1, -1, -1 - stride};
  uint32_t ring = 0;
  for (size_t k = 0; k < offsets.size(); ++k) ring |= (pixel[offsets[k]] != 0 ? 1U : 0U) << k;
  return ring;
}

/// Whether a ring has its pixel k, counted around.
inline bool has_pixel(uint32_t ring, int k) { return ((ring >> (k % 8)) & 1U) != 0; }

struct RingCount {
  int pixels = 0;
  int runs = 0;  ///< of pixels beside each other; 0 for a full ring
};

inline RingCount count_ring(uint32_t ring) {
  RingCount count;
  for (int k = 0; k < 8; ++k) {
    count.pixels += has_pixel(ring, k) ? 1 : 0;
    count.runs += !has_pixel(ring, k) && has_pixel(ring, k + 1) ? 1 : 0;
  }
  return count;
}

}  // namespace relievo
