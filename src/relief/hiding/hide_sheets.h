#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "kernel/operators/gradient.h"
#include "relief/discretisation/discretisation.h"
#include "relief/hiding/hidden_sheets.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The surface that is seen from the front, and what was computed of it.
struct HidingInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
  const Inflation& inflation;
  const Ordering& ordering;
};

/// The flaps of a mesh, and the matrix of the nodes inside them: all that hiding keeps from one
/// call to the next.
class FlapSystem {
 public:
  /// O(N + faces), and an analysis of the flaps' nodes. Of no use where `context` is cancelled.
  FlapSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
             const RunContext& context);

  /// Gives the nodes inside flaps u and g: the Poisson problem of their part and the smoothest
  /// shift that go on from the nodes at their edges, both free along the cut at the join. One
  /// factorisation each.
  void fill(const HidingInput& input, const RunContext& context, HiddenSheets& sheets);

  /// Gives them the gradients of the g that they have.
  void set_slopes(Ordering& ordering) const;

 private:
  bool solve(const Eigen::VectorXd& load, const std::vector<uint8_t>& fixed,
             const RunContext& context, std::vector<double>& values);

  std::vector<Point2> positions_;          ///< #N, px
  std::vector<int> flaps_;                 ///< faces of the mesh
  std::vector<std::array<int, 3>> faces_;  ///< their nodes
  std::vector<int> nodes_;                 ///< inside flaps, ascending
  GradientStencils gradients_;             ///< on the flaps alone, 1 / px
  SparseMatrix L_;                         ///< #N x #N
  SparseMatrix K_;                         ///< of nodes_, lower triangle
  SparseCholesky factor_;
};

/// Brings what is hidden below what is seen, which stays as it is: flaps are inflated and hung up
/// at the edges where they go on from the rest of their sheet, and hidden nodes that come out in
/// front are lowered, node by node and where faces cross between nodes. For models with hidden
/// surfaces only. `flaps` is nothing, or what a call left with the same mesh and discretisation.
/// O(F), and a factorisation of the flaps.
HiddenSheets hide_sheets(const HidingInput& input, std::optional<FlapSystem>& flaps,
                         const RunContext& context = {});

}  // namespace relievo::relief
