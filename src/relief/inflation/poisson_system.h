#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/run_context.h"
#include "kernel/base/sparse_matrix.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"

namespace relievo {

/// The Poisson problem of a surface, whose matrix is analysed once and factorised again only as far
/// as its boundary conditions change.
class PoissonSystem {
 public:
  /// Unknowns are the nodes that are not on outlines, in the discretisation's order. Systems that
  /// are to be solved with several boundary conditions are best incremental. Where `context` is
  /// cancelled the system is of no use.
  PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                Refactorisation refactorisation, const RunContext& context);

  /// Solves (L + B) u = load with u = 0 on outlines and where `fixed` (#N flags) says so; B is the
  /// diagonal matrix of `spring`, #N, without unit. Nothing where there is no finite solution or
  /// `context` is cancelled.
  std::optional<Eigen::VectorXd> solve(const std::vector<uint8_t>& fixed,
                                       const Eigen::VectorXd& spring, const Eigen::VectorXd& load,
                                       const RunContext& context);

 private:
  std::vector<int> unknown_;  ///< #N, -1 on outlines
  std::vector<int> node_;     ///< of each unknown
  SparseMatrix L_;            ///< of the unknowns, lower triangle
  SparseMatrix A_;            ///< with the last springs
  SparseCholesky factor_;
  std::vector<uint8_t> held_;  ///< of each unknown, in the factor; empty where there is none
  ForwardSweep sweep_;         ///< of the last solution
};

}  // namespace relievo
