#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "relievo/image.h"

namespace relievo {

/// Computes the largest value within the square of side 2 radius + 1 around each pixel, clipped by
/// the image, for each channel separately. Precondition: radius >= 0. One pass: O(values) along
/// columns, whatever the radius (van Herk 1992; Gil, Werman 1993), and O(values log radius) along
/// rows, which vectorises and is faster there.
Image8 max_filter(const Image8& image, int radius);

/// Computes the smallest value within that square.
Image8 min_filter(const Image8& image, int radius);

/// Removes whatever is darker than its surroundings and narrower than the square (closing).
Image8 close_gaps(const Image8& image, int radius);

/// Removes whatever is brighter than its surroundings and narrower than the square (opening).
Image8 remove_specks(const Image8& image, int radius);

/// Returns 1 - mask, for a mask of zeros and ones.
Image8 complement(const Image8& mask);

/// Thins the pixels of `mask` (one channel) that are not 0 to connected curves one pixel wide that
/// keep their ends: 255 on them, 0 elsewhere (Zhang, Suen 1984). O(pixels * largest half width).
Image8 thin(const Image8& mask);

/// Returns the eight pixels around one as bits, clockwise from the one above: 1 where a pixel is
/// not 0. Precondition: the pixel is not at the edge of its image, which has one channel and rows
/// `stride` apart.
inline uint32_t ring_around(const uint8_t* pixel, int stride) {
  const std::array<int, 8> offsets = {-stride, 1 - stride, 1,  1 + stride,
                                      stride,  stride - 1, -1, -1 - stride};
  uint32_t ring = 0;
  for (size_t k = 0; k < offsets.size(); ++k) ring |= (pixel[offsets[k]] != 0 ? 1U : 0U) << k;
  return ring;
}

/// Returns bit k of a ring, modulo 8.
inline bool has_pixel(uint32_t ring, int k) { return ((ring >> (k % 8)) & 1U) != 0; }

/// Counts the runs of consecutive ones around a ring; 0 for a full ring.
inline int runs_in_ring(uint32_t ring) {
  int runs = 0;
  for (int k = 0; k < 8; ++k) runs += !has_pixel(ring, k) && has_pixel(ring, k + 1) ? 1 : 0;
  return runs;
}

}  // namespace relievo
