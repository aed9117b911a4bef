#pragma once

#include "kernel/geometry/box3.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// Returns the box around all vertices of a model. Precondition: there is at least one.
Box3 extent(const Model& model);

/// Returns the longest side of that box.
double longest_side(const Model& model);

/// Maps positions of a model to those in a file: scale * (position - origin). A standing model is
/// stood up first.
struct Placement {
  double scale = 1;
  Point3 origin;
  bool standing = false;
};

inline Point3 place(const Placement& placement, Point3 p) {
  return placement.scale * ((placement.standing ? stood_up(p) : p) - placement.origin);
}

/// Returns the placement whose longest side is `size`, with the middle at x = y = 0, or the lowest
/// point at y = 0 if `grounded`, and the drawing plane at z = 0.
Placement centred_placement(const Model& model, double size, bool grounded = false);

/// Returns the placement whose longest side is `size`, lying or standing in the positive octant and
/// touching its three planes.
Placement octant_placement(const Model& model, double size, bool standing = false);

/// The placed vertices of a model, those at one place shared.
struct SharedVertices {
  std::vector<std::array<float, 3>> places;  ///< in the order of their first vertices
  std::vector<int> number;                   ///< #V index in `places`
};

/// Shares the vertices whose placed coordinates are equal as floats. O(V).
SharedVertices share_vertices(const Model& model, const Placement& placement);

/// Returns the normal with unit length; the viewing direction for a zero normal, which no file may
/// hold.
inline Point3 file_normal(Point3 normal) {
  const Point3 n = normalized(normal);
  return n == Point3{} ? Point3{0, 0, 1} : n;
}

/// Checks what every mesh file needs: at least one triangle, finite vertices, an extent and a
/// finite positive `size_mm`. Errors: `bad_input`, `usage` for the size.
Status check_exportable(const Model& model, double size_mm);

}  // namespace relievo
