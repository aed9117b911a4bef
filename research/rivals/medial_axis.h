#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"

namespace relievo::research {

/// The pruned medial axis of a region: discs that touch its outline in two points or more.
struct MedialAxis {
  std::vector<Point2> centre;             ///< px
  std::vector<double> radius;             ///< distance of each centre to the outline, px
  std::vector<std::array<int, 2>> edges;  ///< between centres; none if the axis is one point
};

/// Computes the medial axis from the Voronoi diagram of the outline, sampled every `spacing` px.
/// Prunes branches whose discs touch the outline at points that are less than 1.6 times as far
/// apart along it as straight: those of noise, round ends (pi / 2) and corners above 77 degrees.
/// Keeps the largest disc if nothing else remains. Thins centres to about two per radius. Empty for
/// a region without samples. Errors: as triangulate. O(n log n).
Result<MedialAxis> medial_axis(const Outline& outline, double spacing);

}  // namespace relievo::research
