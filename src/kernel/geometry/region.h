#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// A plane region: an outline whose rings do not cross, outer rings with positive area, holes with
/// negative. All results of the functions below are such, with coordinates rounded to 1/1024 px.
/// Each of them costs O(n log n + crossings).
using Region = Outline;

/// Computes the union of two regions.
Region unite(const Region& p, const Region& q);

/// Computes the union of all regions.
Region unite(const std::vector<Region>& regions);

/// Computes the points that are in both regions.
Region intersect(const Region& p, const Region& q);

/// Computes the points of p that are not in q.
Region subtract(const Region& p, const Region& q);

/// Computes the points within `distance` (px) of the region. A negative distance shrinks it to the
/// points that are farther than -distance from its outside. Corners are round.
Region grow(const Region& region, double distance);

/// Returns whether the closed boxes have a point in common.
bool boxes_meet(const Box2& p, const Box2& q);

/// Returns the connected pieces, each with its holes, largest first.
std::vector<Region> pieces(const Region& region);

/// Fills the holes of the region.
Region without_holes(const Region& region);

/// Drops rings below `min_area` (px^2), and points that change the outline by less than `tolerance`
/// (px). No two points of the result coincide.
Region tidied(const Region& region, double tolerance, double min_area);

}  // namespace relievo
