#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"

namespace relievo {

/// The surface of a solid: every edge has two triangles, which look outwards, and none cross.
struct ClosedMesh {
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Where a triangle of a union comes from.
struct UnitedSource {
  int mesh = 0;      ///< 0 or 1
  int triangle = 0;  ///< of that mesh, which it is a piece of
};

struct UnitedMesh {
  ClosedMesh mesh;
  std::vector<UnitedSource> sources;  ///< by triangle
  int pieces = 0;                     ///< that do not hang together
  double filled = 0;                  ///< volume of the hollows that were filled
};

/// What lies in either of two solids, its points rounded to multiples of `unit`, on which those of
/// the solids lie. Hollows that nothing leads to are filled. Fails with internal where the rounded
/// surface is not one of a solid, as where both touch without crossing; the same solids a little
/// moved may do. Near-linear.
Result<UnitedMesh> unite_meshes(const ClosedMesh& first, const ClosedMesh& second, double unit);

}  // namespace relievo
