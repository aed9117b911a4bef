#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "relief/nonlinear/bound_step.h"
#include "relief/nonlinear/contact_step.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/depth_problem.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Where the iteration stands; scene units.
struct NonlinearState {
  Eigen::VectorXd u;      ///< #N, its root is f; on loose B of the other sign where the gap is -f
  Eigen::VectorXd load;   ///< #N, with which the depth pairs change u
  std::vector<double> h;  ///< #N, px, obeys the pairs; empty before the first end
};

/// How firmly the steps take what they do not know exactly.
struct Softness {
  double share = 1;  ///< of the compliance of soft nodes that counts; larger is slower and firmer
  double bound = 0;  ///< what resists steps on B besides, BoundStep::resist
  double width = 0;  ///< of the root where u may have either sign, scene units
};

/// What the steps of the iteration solve with.
struct NonlinearSystems {
  const InflationResponse& inflation;
  DepthSystem& order;  ///< under the pairs of the problem
  BoundStep& bound;    ///< prepared
};

/// The fixed-point problem x = F(x) of the non-linear formulation. F orders the parts for the
/// present inflation, moves f on B against the slope of the energy, and then solves the inflation
/// under the forces of the contact. x holds u at the nodes on which depth pairs press, f on B, and
/// the loads of soft nodes, all scaled to the unit of u.
class NonlinearMap {
 public:
  /// Begins with the gaps closed that are so in the order, and keeps what the steps learn in the
  /// systems.
  NonlinearMap(const NonlinearSystems& systems, const Softness& softness);

  /// Makes what else the steps need; false where `context` is cancelled.
  bool prepare(const RunContext& context) { return contact_step_.prepare(context); }

  Eigen::VectorXd pack(const NonlinearState& state) const;

  /// Puts x into a state that a step has left. What would change sign, or shrink to a tenth, stays
  /// as the step has left it: only its root has a meaning.
  void unpack(const Eigen::VectorXd& x, NonlinearState& state) const;

  /// One step: leaves F in `state`, but for its heights, and says what it cost. Precondition:
  /// prepared.
  SolveStatus apply(NonlinearState& state, NonlinearStep& step, const RunContext& context);

  /// The heights of the last step, whose u is that of `state`.
  void find_heights(NonlinearState& state) const;

  /// Gaps that were held closed in the last step though they would have come loose, by their
  /// children.
  const std::vector<int>& pulled() const { return pulled_; }

 private:
  Eigen::VectorXd fixed_f(const NonlinearState& state) const;
  Eigen::VectorXd f_on_bound(const NonlinearState& state) const;
  Eigen::VectorXd opening(const Eigen::VectorXd& f) const;
  Eigen::VectorXd squares_on_bound(const Eigen::VectorXd& f) const;
  void set_loose(const Eigen::VectorXd& f, NonlinearState& state) const;
  bool is_open(Eigen::Index i, double f) const;
  void keep_loose_within_reach(const NonlinearState& state, Eigen::VectorXd& f_bound) const;
  std::vector<int> pulled_gaps(const Eigen::VectorXd& f, const Contact& contact) const;
  Springs springs(const NonlinearState& state) const;
  Eigen::VectorXd next_load(const Eigen::VectorXd& f, const NonlinearState& state,
                            const Contact& contact) const;
  Eigen::VectorXd slope_on_bound(const Eigen::VectorXd& f, const Contact& contact,
                                 const Excess& excess) const;
  Eigen::VectorXd springs_on_bound(const Eigen::VectorXd& f, const Excess& excess) const;
  Eigen::VectorXd compliance_of_soft_nodes(double share) const;

  const SmoothRoot& root(int node) const {
    return model_.sign[node] == 0 ? smooth_root_ : sharp_root_;
  }

  const NonlinearModel& model_;
  const InflationResponse& response_;
  SmoothRoot sharp_root_;
  SmoothRoot smooth_root_;  ///< where u may have either sign
  std::vector<int> nodes_;  ///< on which pairs press, off B
  std::vector<int> apart_;  ///< on which none do, off B
  std::vector<int> soft_;   ///< those of nodes_ whose f is unknown in the contact
  Eigen::VectorXd held_f_;  ///< #N, f where it is neither free nor on B; 0 elsewhere
  ContactStep contact_step_;
  const SparseMatrix& gap_columns_;  ///< what heights do when a gap opens
  BoundStep& bound_step_;
  Eigen::Index bounds_;  ///< #B
  std::vector<int> pulled_;
  Eigen::VectorXd compliance_;  ///< of the soft nodes: change of u for a change of load
};

}  // namespace relievo::relief
