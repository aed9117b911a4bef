#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::research {

/// A piece of a skeleton: a segment whose radius changes linearly, or a point if both ends are the
/// same. Radii are > 0.
struct Bone {
  Point3 a;
  Point3 b;
  double radius_a = 1;
  double radius_b = 1;
};

/// Computes the scale-invariant integral of Zanni et al. 2013 (SCALIS), as Entem et al. 2015 use
/// it:
///   F(P) = 1.49683 integral of (1 - x^2 / 4)^3 dt / tau over the bone,
/// x = |P - S(t)| / tau(t) < 2, where tau is the radius. F is 1 at a distance of tau from an
/// infinite line. A point has (1 - x^2 / 4)^3 / (3 / 4)^3 (our reading), which is 1 at its radius.
/// Gauss quadrature, exact for a constant radius, else to some 1e-6.
double field(const Bone& bone, Point3 p);

/// The sum of the fields of bones. It is 1 on the surface, and larger inside.
class Convolution {
 public:
  explicit Convolution(std::vector<Bone> bones);

  double value(Point3 p) const;

  /// Computes the gradient of the value by differences. It is 0 far from all bones.
  Point3 gradient(Point3 p) const;

  /// Computes the mean radius of the bones at p, weighted by their fields; 0 far from all bones.
  double radius(Point3 p) const;

  const std::vector<Bone>& bones() const { return bones_; }

 private:
  /// Calls visit(bone) for all bones whose field at p may differ from 0.
  template <class Visit>
  void for_each_near(Point3 p, Visit visit) const;

  std::vector<Bone> bones_;
  Point3 origin_;  ///< of a grid on the front view
  double cell_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<int>> near_;  ///< the bones that reach each cell, row by row
};

/// A triangle mesh.
struct TriangleSurface {
  std::vector<Point3> positions;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// Extracts the surface on which a convolution is 1, closed and manifold, by CGAL's Delaunay
/// refinement. Triangles lie in circles whose radius is `cell` times that of the bones there, at
/// least `smallest` (> 0). Refinement begins at every bone, so that no piece is missed. Errors:
/// `limit` above two million triangles, `interrupted`.
Result<TriangleSurface> contour(const Convolution& convolution, double cell, double smallest,
                                const RunContext& context = {});

}  // namespace relievo::research
