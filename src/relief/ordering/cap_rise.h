#pragma once

#include <Eigen/Core>
#include <array>
#include <set>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A cap is a part that grows out of nothing, is tied to one behind it and covers a run of the
/// outline of that: a hat on a head, a head on a neck. Here is all of it but its heights.
struct Cap {
  int part = 0;
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

/// The shift by which spots lie on what they are tied to, #N in scene units, 0 but on them. Eyes,
/// noses and patches are glued along an outline that is higher at one end than at the other, and
/// with the least gradient they would bend what they lie on, off the drawing plane. So a spot is
/// wanted on the plane that departs least from what lies below it. It is a part that may be a cap,
/// is none, and lies on what it is tied to with all its area and that of what grows out of it; it
/// is less of a spot the more sticks out, up to a tenth, which comes along. `height`: #N scene
/// units, of all parts without spots. O(F + height of the stacks).
Eigen::VectorXd spot_rise(const LayeredMesh& mesh, const Scene& scene, const Caps& caps,
                          Eigen::VectorXd height);

}  // namespace relievo::relief
