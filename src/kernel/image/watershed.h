#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// Grows the seeds of `label` (values > 0) over all pixels of value 0 that they can reach across
/// shared sides, lowest `height` first and, at one height, nearest to the seeds first, so that
/// fronts meet on ridges. Pixels with negative labels are walls. Precondition: both images have one
/// channel and the same size. Priority flood with 256 queues (Meyer 1994). O(pixels).
void flood_from_seeds(const Image8& height, Image<int32_t>& label);

/// A peak has a basin of its own only where it rises enough above the pass to a higher one.
struct BasinOptions {
  double min_rise = 1.5;      ///< least rise of the peak above the pass, px
  double max_pass_ratio = 1;  ///< largest height of the pass over that of the peak
};

/// The basins of a distance field.
struct PeakBasins {
  Image<int32_t> label;       ///< 0 where the distance is 0, else 1 .. #B
  std::vector<double> peaks;  ///< [#B + 1] highest distance in a basin, px; [0] is 0
};

/// Computes the watershed of a distance field from its peaks down: one basin for each peak of
/// `squared_distance` (px^2, one channel) that satisfies the options, in the order of the peaks,
/// highest first. Neighbours are pixels that share a side. A pixel belongs to the basin of its
/// highest neighbour, so that no queue is needed: only peaks and borders are sorted. O(pixels).
PeakBasins peak_basins(const Image<int32_t>& squared_distance, const BasinOptions& options = {});

}  // namespace relievo
