#pragma once

#include <cmath>

#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/point.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A joined surface with its heights, which models and maps are made of.
struct SolvedSurface {
  const LayeredMesh& mesh;
  const Inflation& inflation;
  const Ordering& ordering;
  const Scene& scene;
};

/// The relief at one point of a face. All members vary linearly over the face; height and normal
/// are computed from them, never interpolated.
struct SurfaceSample {
  double u = 0;   ///< px^2, signed square of the inflated height
  double g = 0;   ///< px, shift
  Point2 grad_u;  ///< px, canvas axes (y down)
  Point2 grad_g;  ///< canvas axes (y down)
};

/// Returns the height towards the viewer, px.
inline double height(const SurfaceSample& s) { return s.g + signed_root(s.u); }

/// Returns the unit normal ~ (-1/2 grad u - |f| grad g, |f|) in model axes (Y up): finite and
/// horizontal at outlines, where the slope of the height is infinite; (0, 0, 1) if both terms
/// vanish.
inline Point3 surface_normal(const SurfaceSample& s) {
  const double f = std::sqrt(std::abs(s.u));
  const Point2 slope = 0.5 * s.grad_u + f * s.grad_g;
  const Point3 normal = normalized({-slope.x, slope.y, f});
  return normal == Point3{} ? Point3{0, 0, 1} : normal;
}

/// Returns the sample at a node.
inline SurfaceSample node_sample(const SolvedSurface& surface, int node) {
  const auto& [u, grad_u] = surface.inflation;
  return {u[node], surface.ordering.g[node], grad_u[node], surface.ordering.grad_g[node]};
}

/// Returns the sample at a corner of a face, on the face's side of a crease.
SurfaceSample corner_sample(const SolvedSurface& surface, int face, int corner);

/// Returns (1 - t) a + t b.
inline SurfaceSample interpolate(const SurfaceSample& a, const SurfaceSample& b, double t) {
  const double s = 1 - t;
  return {s * a.u + t * b.u, s * a.g + t * b.g, s * a.grad_u + t * b.grad_u,
          s * a.grad_g + t * b.grad_g};
}

/// Checks that there are one finite value per node, a part for every face and a canvas with area.
/// Fails with internal or bad_input. O(nodes + faces).
Status check_surface(const SolvedSurface& surface);

}  // namespace relievo::relief
