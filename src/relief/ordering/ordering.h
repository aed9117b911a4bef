#pragma once

#include <vector>

#include "kernel/geometry/triangles.h"
#include "kernel/solvers/active_set.h"
#include "relievo/point.h"

namespace relievo::relief {

/// Gradients at face corners on and beside creases. Each uses the values on its own side only.
struct CreaseGradients {
  std::vector<Corner> corner;    ///< ascending
  std::vector<Point2> gradient;  ///< of g, canvas axes (y down)
};

/// Final heights h = f + g [P eq 10-13].
struct Ordering {
  std::vector<double> h;       ///< #N, px towards the viewer
  std::vector<double> g;       ///< #N, shift h - f, px
  std::vector<Point2> grad_g;  ///< #N, gradient of g at the node, canvas axes (y down)
  CreaseGradients creases;     ///< replace grad_g at their corners
  /// #N, amount by which hide_sheets lowered h and g, px; empty if it did not run.
  std::vector<double> lowered;
  /// Hidden faces that stay in front of a visible one wherever their nodes are put, ascending.
  /// Models leave them out.
  std::vector<int> crossing;
  int overlap_samples = 0;   ///< hidden faces still in front of the next one after hide_sheets
  double overlap_worst = 0;  ///< their largest overlap, px

  int equalities = 0;        ///< nodes fixed at the height of another
  int inequalities = 0;      ///< gaps >= 0
  double max_violation = 0;  ///< worst h[lower] - h[upper] over all pairs, px, 0 if none
  BoundQpReport report;      ///< of the last solve; the energy is the cost of g in scene units
};

}  // namespace relievo::relief
