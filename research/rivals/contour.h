#pragma once

#include <array>
#include <vector>

#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::research {

/// A piece of a skeleton: a segment whose radius changes linearly, or a point where both ends are
/// the same. Radii are > 0.
struct Bone {
  Point3 a;
  Point3 b;
  double radius_a = 1;
  double radius_b = 1;
};

/// The scale-invariant integral of Zanni et al. 2013 (SCALIS), as Entem et al. 2015 use it:
///   F(P) = 1.49683 integral of (1 - x^2 / 4)^3 dt / tau over the bone,
/// x = |P - S(t)| / tau(t), tau the radius, where x < 2: 1 at a distance of tau from an infinite
/// line. A point, over which nothing can be integrated, has (1 - x^2 / 4)^3 / (3 / 4)^3 (our
/// reading): 1 at its radius. By Gauss: exact where the radius is
/// constant, else to some 1e-6.
double field(const Bone& bone, Point3 p);

/// The sum of the fields of bones: the surface is where it is 1, inside it is more.
class Convolution {
 public:
  explicit Convolution(std::vector<Bone> bones);

  double value(Point3 p) const;

  /// Of the value, by differences. 0 far from all bones.
  Point3 gradient(Point3 p) const;

  /// The mean radius of the bones at p, weighted by their fields; 0 far from all of them.
  double radius(Point3 p) const;

  const std::vector<Bone>& bones() const { return bones_; }

 private:
  /// Calls visit(bone) for all bones whose field may not be 0 at p.
  template <class Visit>
  void for_each_near(Point3 p, Visit visit) const;

  std::vector<Bone> bones_;
  Point3 origin_;  ///< of a grid over the front view
  double cell_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<int>> near_;  ///< per cell, row by row: bones that reach it
};

/// Triangles in space.
struct TriangleSurface {
  std::vector<Point3> positions;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// The surface on which a convolution is 1, closed and manifold, by CGAL's Delaunay refinement of
/// surfaces: triangles within circles of `cell` times the radius of the bones there, at least
/// `smallest` (> 0). Refinement begins at every bone, so that no piece is missed. Fails with limit
/// where there are more than two million triangles, or interrupted.
Result<TriangleSurface> contour(const Convolution& convolution, double cell, double smallest,
                                const RunContext& context = {});

}  // namespace relievo::research
