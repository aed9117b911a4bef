#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"

namespace relievo::research {

/// The pruned medial axis of a region: discs that touch its outline in at least two places.
struct MedialAxis {
  std::vector<Point2> centre;             ///< px
  std::vector<double> radius;             ///< likewise; of every centre, distance to the outline
  std::vector<std::array<int, 2>> edges;  ///< between centres; none where the axis is one point
};

/// The Voronoi diagram of the outline sampled every `spacing` px, without the branches whose discs
/// touch the outline at places that are less than 1.6 times as far apart along it as straight:
/// those of noise, of round ends (pi / 2) and of corners above 77 degrees. Where nothing is left,
/// the largest disc. Centres are thinned to about two a radius. Empty for a region without samples.
/// Fails as triangulate. O(n log n).
Result<MedialAxis> medial_axis(const Outline& outline, double spacing);

}  // namespace relievo::research
