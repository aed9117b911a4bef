#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/run_context.h"
#include "kernel/solvers/bound_qp.h"
#include "relief/joint/joint_model.h"
#include "relief/joint/soft_matrix.h"
#include "relief/ordering/depth_problem.h"

namespace relievo {

/// What keeps the unknown f of the soft nodes: 1/2 stiffness f^2 - pull f, in scene units.
struct Springs {
  Eigen::VectorXd stiffness;  ///< positive
  Eigen::VectorXd pull;
};

/// Where the parts come to lie for a given inflation.
struct Contact {
  SolveStatus status = SolveStatus::solved;
  int factorisations = 0;
  Eigen::VectorXd soft;     ///< one per soft node: what is added to its f
  Eigen::VectorXd force;    ///< #N, lambda_shift (A g - pull): what the depth pairs press with
  double shift_energy = 0;  ///< twice lambda_shift times the cost of g
  std::vector<double> h;    ///< #N, px
};

/// Minimises lambda_shift times the cost of g and the springs over g and the soft nodes' f under
/// the depth pairs. A bound-constrained program whose pattern, factor and start are kept from one
/// step to the next; without soft nodes that is the depth order.
class ContactStep {
 public:
  /// closed: gaps of the problem that are closed in the first guess.
  ContactStep(const JointModel& model, const DepthProblem& problem, const std::vector<int>& soft,
              const std::vector<uint8_t>& closed);

  /// Analyses the matrix; false where `context` is cancelled.
  bool prepare(const RunContext& context);

  /// f: #N in scene units, what is fixed of it. Precondition: prepared. Factorises what the active
  /// set changes.
  Contact solve(const Eigen::VectorXd& f, const Springs& springs, const RunContext& context);

  /// The depth order's program with the last factor and active set, taken from here; nothing where
  /// there are soft nodes.
  std::optional<DepthSystem> release() &&;

 private:
  const JointModel& model_;
  const DepthProblem& problem_;
  SoftMatrix matrix_;
  BoundQp qp_;
  std::vector<uint8_t> active_;
  Eigen::VectorXd last_;  ///< solution; empty at first
  SparseCholesky factor_;
};

}  // namespace relievo
