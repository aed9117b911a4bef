#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"

namespace relievo {

/// The surface of a solid: every edge has two triangles, all face outwards, and none cross.
struct ClosedMesh {
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// The origin of a triangle of a union.
struct UnitedSource {
  int mesh = 0;      ///< 0 or 1
  int triangle = 0;  ///< the triangle of that mesh of which it is a piece
};

/// The union of two solids.
struct UnitedMesh {
  ClosedMesh mesh;
  std::vector<UnitedSource> sources;  ///< of each triangle
  int pieces = 0;                     ///< number of connected components
  double filled = 0;                  ///< volume of the filled hollows, cubed units
};

/// Computes the union of two solids, with points rounded to multiples of `unit`. Fills closed
/// hollows. Precondition: the points of both solids are multiples of `unit`. Fails with internal
/// where the rounded surface is not that of a solid, for example where both touch without crossing;
/// moving one of them a little may help. Not available in the browser. Near-linear.
Result<UnitedMesh> unite_meshes(const ClosedMesh& first, const ClosedMesh& second, double unit);

}  // namespace relievo
