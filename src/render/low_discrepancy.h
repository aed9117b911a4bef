#pragma once

#include <cstdint>

#include "relievo/point.h"

namespace relievo {

/// A well mixed function of its arguments.
inline uint32_t hash(uint32_t a, uint32_t b, uint32_t c) {
  uint32_t h = a * 0x9e3779b1U ^ (b + 0x7f4a7c15U) * 0x85ebca77U ^ (c + 0x165667b1U) * 0xc2b2ae3dU;
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  return h ^ h >> 16;
}

/// Point i of the additive recurrence over the plastic number (M. Roberts, 2018), in fixed-point
/// numbers that wrap: any run of it fills the unit square evenly.
inline Point2 even_point(uint32_t i) {
  return {(i * 3242174889U + 0x80000000U) * 0x1p-32, (i * 2447445414U + 0x80000000U) * 0x1p-32};
}

/// The place of a pixel on a curve that visits every block of 2^k x 2^k pixels in one go, each in
/// an order of its own; x, y < 16384. Pixels that take their samples from consecutive runs of one
/// sequence in this order have errors that cancel between neighbours, which looks like fine, even
/// grain (A. Ahmed, P. Wonka: Screen-space blue-noise diffusion of Monte Carlo sampling error via
/// hierarchical ordering of pixels, 2020). `seed` gives another curve.
inline uint32_t block_order(uint32_t x, uint32_t y, uint32_t seed) {
  uint32_t order = 0;
  for (int level = 13; level >= 0; --level) {
    const uint32_t quarter = (x >> level & 1) | (y >> level & 1) << 1;
    const uint32_t turn = hash(x >> (level + 1), y >> (level + 1), seed + level) & 3;
    order = order << 2 | (quarter ^ turn);
  }
  return order;
}

}  // namespace relievo
