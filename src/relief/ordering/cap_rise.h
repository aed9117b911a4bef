#pragma once

#include <Eigen/Core>
#include <array>
#include <set>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo {

/// A cap is a part that grows out of nothing, is tied to one behind it and covers a run of the
/// outline of that: a hat on a head, a head on a neck. Here is all of it but its heights.
struct Cap {
  double share = 0;                    ///< how much of a cap it is, in (0, 1]
  std::vector<int> rim;                ///< nodes of its outline where a height is wanted, ascending
  std::vector<std::array<int, 2>> on;  ///< places in `rim`, each with a node that it lies on
  std::vector<int> inner;              ///< other nodes of it and of what grows out of it, ascending
  SparseMatrix coupling;               ///< #inner x #rim, of the metric
  SparseCholesky factor;               ///< of the metric on `inner`
};

/// The caps of a surface.
struct Caps {
  std::vector<std::set<int>> tied;  ///< what they were found for
  std::vector<Cap> caps;
};

/// By part, those behind it that it may be a cap of: to which it is tied (is_tie, without a
/// range), all with d > 0; none where it has a lean or grows. O(parts + joins + relations log).
std::vector<std::set<int>> tied_parts(const Scene& scene);

/// `A`: of the metric of shifts. How much of a cap a part is depends gradually on the shares of the
/// two outlines that lie on each other, and of its own where nothing is behind it. O(F + height of
/// the stacks), and for each cap a factorisation on its nodes.
Caps find_caps(const LayeredMesh& mesh, const Discretisation& discretisation, const Scene& scene,
               const SparseMatrix& A);

/// The shift by which caps close round what they lie on, #N in scene units, 0 but on them. Where a
/// cap crosses what it is tied to it must come as far forward as that, and the whole of it would
/// follow, off the other's outline. So it is wanted at the height of what it is tied to along its
/// own outline, at 0 where nothing lies behind that, and between as a soap film. What grows out of
/// it comes along. `scale`: scene units per px. O(N), and a solve for each cap.
Eigen::VectorXd cap_rise(const Caps& caps, const Inflation& inflation, double scale);

}  // namespace relievo
