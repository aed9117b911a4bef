#pragma once

#include <Eigen/Core>
#include <array>
#include <set>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A cap: a part that grows out of nothing, is tied to a part behind it and covers a run of that
/// part's outline, as a hat on a head does or a head on a neck. Its heights are not part of it.
struct Cap {
  int part = 0;
  double share = 0;                    ///< degree to which the part is a cap, in (0, 1]
  std::vector<int> rim;                ///< nodes of its outline with a fixed height, ascending
  std::vector<std::array<int, 2>> on;  ///< index in `rim` and a node below it, which it lies on
  std::vector<int> inner;  ///< other nodes of it and of parts growing out of it, ascending
  SparseMatrix coupling;   ///< #inner x #rim block of the metric
  SparseCholesky factor;   ///< of the #inner x #inner block of the metric
};

/// Returns for each part the parts behind it that it may be a cap of: those it is tied to (is_tie,
/// without a range), all with d > 0. Empty for parts that lean or grow out of another.
/// O(parts + joins + relations log).
std::vector<std::set<int>> tied_parts(const Scene& scene);

/// Finds the caps of a surface. `tied`: tied_parts of the scene; `A`: the matrix of the metric. The
/// share of a cap grows with the shares of both outlines that lie on each other and of its own
/// outline that has nothing behind it. O(F + height of the stacks), and a factorisation for each
/// cap on its nodes.
std::vector<Cap> find_caps(const SurfaceInput& surface, const std::vector<std::set<int>>& tied,
                           const SparseMatrix& A);

/// Returns the shift that closes caps round what they lie on, #N in scene units, 0 off caps. With
/// the least gradient alone, a cap would come forward as a whole until it clears what it crosses.
/// The wanted height of its outline is therefore the height f of the part it is tied to, 0 where
/// nothing lies behind, and the shift between is that of least cost. Parts that grow out of it
/// follow. `scale`: scene units per px. O(N), and a solve for each cap.
Eigen::VectorXd cap_rise(const std::vector<Cap>& caps, const Inflation& inflation, double scale);

/// Returns the shift that lays spots on what they are tied to, #N in scene units, 0 off spots. An
/// eye, nose or patch is glued along an outline that is higher at one end than at the other. With
/// the least gradient alone it would bend what it lies on. Its wanted shift is therefore the plane
/// nearest to the surface below it. A spot is a tied part (tied_parts) that is no cap and lies on
/// the part it is tied to with all its area and that of parts growing out of it; its share falls to
/// 0 when a tenth sticks out. `height`: #N, heights of all parts without spots, scene units.
/// O(F + height of the stacks).
Eigen::VectorXd spot_rise(const SurfaceInput& surface, const std::vector<std::set<int>>& tied,
                          const std::vector<Cap>& caps, Eigen::VectorXd height);

}  // namespace relievo::relief
