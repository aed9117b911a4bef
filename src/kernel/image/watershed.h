#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// Grows the seeds of `label` (values > 0) over all pixels of value 0 that they can reach by
/// steps over shared sides, lowest `height` first and, at one height, nearest to the seeds first:
/// fronts meet on the ridges. Pixels with negative labels are walls. Both images have one channel
/// and the same size. Priority flood with 256 queues (Meyer 1994). O(pixels).
void flood_from_seeds(const Image8& height, Image<int32_t>& label);

/// A peak is worth a basin of its own only where it rises enough above the pass to a higher one.
struct BasinOptions {
  double min_rise = 1.5;      ///< of the peak over the pass, px
  double max_pass_ratio = 1;  ///< highest pass, as a fraction of the lower peak
};

struct PeakBasins {
  Image<int32_t> label;       ///< 0 where the distance is 0, else 1 ... #B
  std::vector<double> peaks;  ///< [#B + 1] highest distance in a basin, px; [0] is 0
};

/// Watershed of a distance field from its peaks down: one basin for every peak of
/// `squared_distance` (px^2, one channel) that the options let stand, basins ordered by their
/// peaks, highest first. Neighbours are pixels that share a side. Every pixel belongs to the basin
/// of its highest neighbour, so no queue is needed: only peaks and borders are sorted. O(pixels).
PeakBasins peak_basins(const Image<int32_t>& squared_distance, const BasinOptions& options = {});

}  // namespace relievo
