#include "understanding/areas/settle_edges.h"

#include <cstddef>
#include <cstdlib>

#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int edge_error = 2;  ///< px by which an edge may be off

/// Computes the sum of the differences of all channels between two pixels.
int difference(const Image8& rgb, size_t i, size_t j) {
  int sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += std::abs(rgb.pixels[3 * i + c] - rgb.pixels[3 * j + c]);
  return sum;
}

}  // namespace

void settle_edges(const Image8& rgb, const Image8& barrier, Image<int32_t>& index) {
  const Image8 near_edge =
      max_filter(mask_where(barrier.width, barrier.height,
                            [&](size_t i) { return barrier.pixels[i] == LineMap::edge; }),
                 edge_error);
  const Image<int32_t> flooded = index;
  const auto w = static_cast<size_t>(index.width);
  const auto h = static_cast<size_t>(index.height);
  const size_t reach = 2 * edge_error + 1;
  for (size_t y = reach; y + reach < h; ++y)
    for (size_t i = y * w + reach; i + reach < (y + 1) * w; ++i) {
      if (near_edge.pixels[i] == 0) continue;
      int greatest = 0;
      for (const size_t step : {reach, reach * w}) {
        const size_t before = i - step;
        const size_t after = i + step;
        if (flooded.pixels[before] == flooded.pixels[after]) continue;
        const int contrast = difference(rgb, before, after);
        if (contrast <= greatest) continue;
        greatest = contrast;
        const bool is_before = difference(rgb, i, before) <= difference(rgb, i, after);
        index.pixels[i] = flooded.pixels[is_before ? before : after];
      }
    }
}

}  // namespace relievo::understanding
