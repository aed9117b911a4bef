#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// Plane regions as outlines whose rings do not cross: outer rings of positive area, holes
/// negative. All results of the functions below are such; coordinates are rounded to 1/1024 px.
using Region = Outline;

Region unite(const Region& p, const Region& q);

Region unite(const std::vector<Region>& regions);

Region intersect(const Region& p, const Region& q);

Region subtract(const Region& p, const Region& q);

/// The points nearer than `distance` to the region; with a negative one, those inside it that are
/// farther than -distance from its outside. Round corners.
Region grow(const Region& region, double distance);

/// Whether the closed boxes have a point in common.
bool boxes_meet(const Box2& p, const Box2& q);

/// The connected pieces, each with its holes, the largest first.
std::vector<Region> pieces(const Region& region);

/// The region with its holes filled.
Region without_holes(const Region& region);

/// Drops rings below `min_area` and points that change the outline by less than `tolerance`; no
/// two points of the result coincide.
Region tidied(const Region& region, double tolerance, double min_area);

}  // namespace relievo
