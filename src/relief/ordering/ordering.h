#pragma once

#include <vector>

#include "kernel/geometry/triangles.h"
#include "kernel/solvers/bound_qp.h"
#include "relievo/point.h"

namespace relievo::relief {

/// Gradients at corners of faces on and beside creases, each from its own side.
struct CreaseGradients {
  std::vector<Corner> corner;    ///< ascending
  std::vector<Point2> gradient;  ///< of g, canvas axes (y down)
};

/// Final heights h = f + g [P eq 10-13].
struct Ordering {
  std::vector<double> h;       ///< #N, px towards the viewer
  std::vector<double> g;       ///< #N, shift h - f, px
  std::vector<Point2> grad_g;  ///< #N, gradient of g at the node, canvas axes (y down)
  CreaseGradients creases;     ///< in place of grad_g at their corners
  /// #N, by how much h and g were brought down to hide the node, px; empty where nothing was.
  std::vector<double> lowered;
  /// Faces that come out in front of what hides them wherever their nodes are put, ascending:
  /// models leave them out.
  std::vector<int> crossing;

  int equalities = 0;        ///< nodes held at the height of another
  int inequalities = 0;      ///< pairs kept as gaps
  double max_violation = 0;  ///< worst h[lower] - h[upper] over all pairs, px, 0 if none
  /// Of the last solve; its energy is the cost of g (ShiftMetric), in scene units.
  BoundQpReport report;
};

}  // namespace relievo::relief
