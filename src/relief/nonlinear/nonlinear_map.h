#pragma once

#include <Eigen/Core>
#include <vector>

#include "relief/nonlinear/boundary_step.h"
#include "relief/nonlinear/contact_step.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/depth_system.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// The state of the iteration, in scene units.
struct NonlinearState {
  /// #N, u. At nodes of B with a lifting gap it is y|y| (BoundaryStep): an open gap has the wrong
  /// sign.
  Eigen::VectorXd u;
  Eigen::VectorXd load;   ///< #N, phi: load of the depth pairs on u
  std::vector<double> h;  ///< #N, px, satisfies the pairs; empty before the iteration has converged
};

/// How cautious the steps are.
struct StepControl {
  double compliance = 1;  ///< share of the compliance of mixed nodes that counts; larger is slower
  double stiffness = 0;   ///< added stiffness on B (BoundaryStep::add_stiffness)
  double width = 0;       ///< of the smooth root where u may have either sign, scene units
};

/// The map x = F(x) whose fixed points solve the non-linear problem. One step orders the parts for
/// the present inflation, moves f on B against the gradient, and solves the inflation under the
/// forces of the contact. x holds u at contact nodes, y on B, and the loads of mixed nodes times
/// their compliance, so that all have the unit of u or f.
class NonlinearMap {
 public:
  /// Starts from the active set of `depth`, and keeps active sets and factors in the arguments from
  /// one step to the next. `bound` must be prepared.
  NonlinearMap(const InflationResponse& response, DepthSystem& depth, BoundaryStep& bound,
               const StepControl& control);

  /// Analyses the contact problem. Returns false if `context` is cancelled.
  bool prepare(const RunContext& context) { return contact_step_.prepare(context); }

  Eigen::VectorXd pack(const NonlinearState& state) const;

  /// Puts x into the state that a step has left. A value of u that would change its sign or shrink
  /// to a tenth stays as it is, because only its root has a meaning.
  void unpack(const Eigen::VectorXd& x, NonlinearState& state) const;

  /// Takes one step: replaces u and the load of `state`, and fills in the energy and the number of
  /// factorisations of `step`. Precondition: prepared.
  SolveStatus apply(NonlinearState& state, NonlinearStep& step, const RunContext& context);

  /// Sets h to the heights of the last step, whose u is that of `state`.
  void find_heights(NonlinearState& state) const;

  /// Returns the lifting gaps, named by their children, that were closed in the last step with a
  /// negative multiplier: they pulled.
  const std::vector<int>& pulling() const { return pulling_; }

 private:
  Eigen::VectorXd known_f(const NonlinearState& state) const;
  Eigen::VectorXd y_on_boundary(const NonlinearState& state) const;
  bool is_open(Eigen::Index i, double y) const;
  Eigen::VectorXd opening(const Eigen::VectorXd& y) const;
  Eigen::VectorXd u_on_boundary(const Eigen::VectorXd& y) const;
  void keep_gaps(const Eigen::VectorXd& y, NonlinearState& state) const;
  void limit_gaps(const NonlinearState& state, Eigen::VectorXd& y) const;
  std::vector<int> pulling_gaps(const Eigen::VectorXd& y, const Contact& contact) const;
  Eigen::VectorXd mixed_stiffness(const NonlinearState& state) const;
  Eigen::VectorXd mixed_linear_term(const NonlinearState& state) const;
  Eigen::VectorXd next_load(const Eigen::VectorXd& f, const NonlinearState& state,
                            const Contact& contact) const;
  Eigen::VectorXd gradient_on_boundary(const Eigen::VectorXd& y, const Contact& contact,
                                       const Eigen::VectorXd& boundary_slope) const;
  Eigen::VectorXd sigma_on_boundary(const Eigen::VectorXd& y,
                                    const Eigen::VectorXd& boundary_slope) const;
  Eigen::VectorXd mixed_compliance(double share) const;

  const SmoothRoot& root(int node) const {
    return model_.sign[node] == 0 ? smooth_root_ : sharp_root_;
  }

  const NonlinearModel& model_;
  const InflationResponse& response_;
  SmoothRoot sharp_root_;
  SmoothRoot smooth_root_;          ///< where u may have either sign
  std::vector<int> contact_nodes_;  ///< nodes of I in depth pairs
  std::vector<int> other_nodes_;    ///< nodes of I in none
  std::vector<int> mixed_nodes_;    ///< contact nodes where u may have either sign
  Eigen::VectorXd fixed_f_;         ///< #N, f where it is neither on I nor on B; 0 elsewhere
  ContactStep contact_step_;
  const SparseMatrix& T_;  ///< column: change of the heights when a gap opens
  BoundaryStep& bound_step_;
  Eigen::Index bound_count_;  ///< #B
  std::vector<int> pulling_;
  Eigen::VectorXd compliance_;  ///< #mixed nodes, C: change of u for a change of load
};

}  // namespace relievo::relief
