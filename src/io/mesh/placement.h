#pragma once

#include "kernel/geometry/box3.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// The box around all vertices of a model. Precondition: there is at least one.
Box3 extent(const Model& model);

/// The longest side of that box.
double longest_side(const Model& model);

/// Where a model lies in a file: position in the file = scale * (position - origin), the position
/// stood up before where it stands.
struct Placement {
  double scale = 1;
  Point3 origin;
  bool standing = false;
};

inline Point3 place(const Placement& placement, Point3 p) {
  return placement.scale * ((placement.standing ? stood_up(p) : p) - placement.origin);
}

/// The longest side of the model becomes `size`; its middle lies at x = y = 0 and its drawing
/// plane at z = 0.
Placement centred_placement(const Model& model, double size);

/// The longest side of the model becomes `size`; it lies, or stands, in the positive octant and
/// touches its three planes.
Placement octant_placement(const Model& model, double size, bool standing = false);

/// The normal made exactly unit, towards the viewer where it is zero: files must not have others.
inline Point3 file_normal(Point3 normal) {
  const Point3 n = normalized(normal);
  return n == Point3{} ? Point3{0, 0, 1} : n;
}

/// What every mesh file needs: at least one triangle, finite vertices, an extent and a finite
/// positive `size_mm`. Errors: `bad_input`, `usage` for the size.
Status check_exportable(const Model& model, double size_mm);

}  // namespace relievo
