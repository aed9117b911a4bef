#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "relievo/image.h"

namespace relievo {

/// Largest value within the square of side 2 radius + 1 around each pixel, clipped by the image;
/// each channel by itself. Precondition: radius >= 0. One pass; O(values) along columns, whatever
/// the radius (van Herk 1992; Gil, Werman 1993), and O(values log radius) along rows, which takes
/// less time since it suits vectors.
Image8 max_filter(const Image8& image, int radius);

/// Smallest value within that square.
Image8 min_filter(const Image8& image, int radius);

/// Removes what is darker than its surroundings and narrower than the square.
Image8 close_gaps(const Image8& image, int radius);

/// Removes what is brighter than its surroundings and narrower than the square.
Image8 remove_specks(const Image8& image, int radius);

/// The zeros of a mask, as ones.
Image8 complement(const Image8& mask);

/// The mask's pixels, thinned to connected curves of one pixel that keep their ends: 255 on them,
/// 0 elsewhere. `mask` has one channel. O(pixels * widest half width) (Zhang, Suen 1984).
Image8 thin(const Image8& mask);

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
