#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/run_context.h"

namespace relievo {

/// What holds u on a surface; B has no unit.
struct PoissonBoundary {
  std::vector<uint8_t> fixed;  ///< #N flags: u = 0
  Eigen::VectorXd spring;      ///< #N, to 0: the diagonal of B
  std::vector<double> link;    ///< per ramp node of the mesh, to the node below, where there is one

  friend bool operator==(const PoissonBoundary& a, const PoissonBoundary& b) {
    return a.fixed == b.fixed && a.spring == b.spring && a.link == b.link;
  }
};

/// The Poisson problem of a surface, whose matrix is analysed once and factorised again only as far
/// as its boundary conditions change.
class PoissonSystem {
 public:
  /// Unknowns are the nodes of shaping faces that are not on outlines, in the discretisation's
  /// order. Systems that
  /// are to be solved with several boundary conditions are best incremental. Where `context` is
  /// cancelled the system is of no use.
  PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                Refactorisation refactorisation, const RunContext& context);

  /// Solves (L + B) u = load with u = 0 on outlines and where it is fixed. Nothing where there is
  /// no finite solution or `context` is cancelled.
  std::optional<Eigen::VectorXd> solve(const PoissonBoundary& boundary, const Eigen::VectorXd& load,
                                       const RunContext& context);

 private:
  /// Two unknowns at one place that may be linked.
  struct Link {
    int ramp_node = -1;  ///< of the mesh
    int row = -1;
    int column = -1;  ///< < row
  };

  void collect_links(const LayeredMesh& mesh);
  void set_values(const PoissonBoundary& boundary);

  std::vector<int> unknown_;  ///< #N, -1 on outlines and inside flaps
  std::vector<int> node_;     ///< of each unknown
  std::vector<Link> links_;
  SparseMatrix L_;  ///< of the unknowns, lower triangle, with zeros for links
  SparseMatrix A_;  ///< with the boundary of the factor
  SparseCholesky factor_;
  std::optional<PoissonBoundary> last_;  ///< in the factor, if there is one
  ForwardSweep sweep_;                   ///< of the last solution
};

}  // namespace relievo
