#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/solvers/bound_qp.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/soft_matrix.h"
#include "relief/ordering/depth_problem.h"
#include "relievo/run_context.h"

namespace relievo::relief {

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
};

/// Minimises lambda_shift times the cost of g and the springs over g and the soft nodes' f under
/// the depth pairs. A bound-constrained program whose pattern, factor and start are kept from one
/// step to the next; without soft nodes that is the depth order.
class ContactStep {
 public:
  /// Begins with the gaps closed that are so in `order`. Without soft nodes, works with the program
  /// and the factor there, which are left with the last active set.
  ContactStep(const NonlinearModel& model, DepthSystem& order, const std::vector<int>& soft);

  /// Analyses the matrix if it is not that of `order`; false where `context` is cancelled.
  bool prepare(const RunContext& context);

  /// f: #N in scene units, what is fixed of it. Precondition: prepared. Factorises what the active
  /// set changes.
  Contact solve(const Eigen::VectorXd& f, const Springs& springs, const RunContext& context);

  /// Of the last solution; px, #N.
  std::vector<double> heights() const;

 private:
  void soften(const std::vector<int>& soft);
  void begin_flat();
  Contact solve_softly(const Eigen::VectorXd& f, const Springs& springs, const RunContext& context);
  Contact solve_firmly(const Eigen::VectorXd& f, const RunContext& context);
  Eigen::VectorXd gradient_for(const Eigen::VectorXd& f) const;
  void open_for(const Eigen::VectorXd& f);
  bool is_closed(const DepthGap& gap) const;
  double rise_over_parent(const DepthGap& gap, const Eigen::VectorXd& f) const;

  const NonlinearModel& model_;
  DepthSystem& order_;
  const DepthProblem& problem_;
  bool has_soft_;
  SoftMatrix matrix_;     ///< if there are soft nodes
  DepthSystem own_;       ///< likewise, its gaps and then the soft nodes; without a problem
  Eigen::VectorXd last_;  ///< solution, or where to begin; at first empty with soft nodes
  Eigen::VectorXd last_gradient_;  ///< there, without soft nodes
  Eigen::VectorXd last_f_;         ///< #N, scene units, that it is for
};

}  // namespace relievo::relief
