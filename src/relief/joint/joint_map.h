#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "relief/joint/bound_step.h"
#include "relief/joint/contact_step.h"
#include "relief/joint/inflation_response.h"
#include "relief/joint/joint_model.h"
#include "relief/joint/joint_solution.h"
#include "relief/joint/smooth_root.h"
#include "relief/ordering/depth_problem.h"
#include "relievo/run_context.h"

namespace relievo {

/// Where the iteration stands; scene units.
struct JointState {
  Eigen::VectorXd u;      ///< #N, its root is f; on loose B of the other sign where the gap is -f
  Eigen::VectorXd load;   ///< #N, with which the depth pairs change u
  std::vector<double> h;  ///< #N, px, obeys the pairs; empty before the first end
};

/// Which contact nodes answer within the contact already, and how much.
struct Softness {
  bool all = false;  ///< all of them, not only those where u may have either sign
  double share = 1;  ///< how much of their compliance counts; larger is slower and firmer
  double loose = 0;  ///< what resists steps of loose nodes besides, BoundStep::resist_opening
  double width = 0;  ///< of the root where u may have either sign, scene units
};

/// What the steps of the iteration solve with.
struct JointSystems {
  const InflationResponse& inflation;
  DepthSystem& order;  ///< under the pairs of the problem
  BoundStep& bound;    ///< prepared
};

/// The fixed-point problem x = F(x) of the joint formulation. F orders the parts for the present
/// inflation, moves f on B against the slope of the energy, and then solves the inflation under
/// the forces of the contact. x holds u at the nodes on which depth pairs press, f on B, and the
/// loads of soft nodes, all scaled to the unit of u.
class JointMap {
 public:
  /// Begins with the gaps closed that are so in the order, and keeps what the steps learn in the
  /// systems.
  JointMap(const JointSystems& systems, const Softness& softness);

  /// Makes what else the steps need; false where `context` is cancelled.
  bool prepare(const RunContext& context) { return contact_step_.prepare(context); }

  Eigen::VectorXd pack(const JointState& state) const;

  /// Puts x into the state. What would change sign, or shrink to a tenth at once, shrinks to a
  /// tenth: only its root has a meaning.
  void unpack(const Eigen::VectorXd& x, JointState& state) const;

  /// Enough of a residual F - x to mix by: all of it on B and at soft nodes, a thousand samples of
  /// the others, where it is smooth.
  Eigen::VectorXd measured(const Eigen::VectorXd& residual) const;

  /// One step: leaves F in `state`, but for its heights, and says what it cost. Precondition:
  /// prepared.
  SolveStatus apply(JointState& state, JointStep& step, const RunContext& context);

  /// The heights of the last step, whose u is that of `state`. Solves for gaps that it left aside.
  SolveStatus find_heights(JointState& state, const RunContext& context);

  /// Whether none of these had to close. Precondition: heights were found.
  bool stands() const { return contact_step_.stands(); }

  /// Measures at `state`, where the last step began, how the slope of the energy on B answers when
  /// |f| rises all along B. Where the stiffness of the steps answers less, springs make up for it
  /// from now on. Costs little more than a step. What comes from a similar problem has its springs.
  SolveStatus stiffen(const JointState& state, const RunContext& context);

  /// Gaps that were held closed in the last step though they would have come loose, by their
  /// children.
  const std::vector<int>& pulled() const { return pulled_; }

  /// That of f on B.
  BoundStiffness bound_stiffness() const;

  /// Corrects it by what is measured at `state` near the ends of B. Costs two steps without new
  /// contacts for each end. Measures nothing where there are soft nodes. Fails only when
  /// interrupted. Precondition: a step was made.
  SolveStatus probe_ends(const JointState& state, const RunContext& context,
                         BoundStiffness& stiffness);

 private:
  /// What follows from u and from f on B as they are.
  struct Answer {
    Contact contact;
    Eigen::VectorXd load;   ///< #N, next
    Excess excess;          ///< under it
    Eigen::VectorXd slope;  ///< #B, of the energy / 2 with respect to f
  };

  /// Changes of f on B that span the modes, measured one by one from a state.
  class Prober;

  Answer answer_to(const JointState& state, const RunContext& context);
  /// To another f on B, the inflation within it following.
  Answer answer_to_change(const JointState& state, const Eigen::VectorXd& change,
                          const RunContext& context);
  Eigen::VectorXd fixed_f(const JointState& state) const;
  Eigen::VectorXd f_on_bound(const JointState& state) const;
  Eigen::VectorXd opening(const Eigen::VectorXd& f) const;
  Eigen::VectorXd squares_on_bound(const Eigen::VectorXd& f) const;
  void set_loose(const Eigen::VectorXd& f, JointState& state) const;
  bool is_open(Eigen::Index i, double f) const;
  void keep_loose_within_reach(const JointState& state, Eigen::VectorXd& f_bound) const;
  std::vector<int> pulled_gaps(const Eigen::VectorXd& f, const Contact& contact) const;
  Springs springs(const JointState& state) const;
  Eigen::VectorXd next_load(const Eigen::VectorXd& f, const JointState& state,
                            const Contact& contact) const;
  Eigen::VectorXd slope_on_bound(const Eigen::VectorXd& f, const Contact& contact,
                                 const Excess& excess) const;
  Eigen::VectorXd springs_on_bound(const Eigen::VectorXd& f, const Excess& excess) const;
  Eigen::VectorXd compliance_of_soft_nodes(double share) const;

  const SmoothRoot& root(int node) const {
    return model_.sign[node] == 0 ? smooth_root_ : sharp_root_;
  }

  const JointModel& model_;
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
  Eigen::Index bounds_;    ///< #B
  Eigen::VectorXd slope_;  ///< #B, of the energy / 2 with respect to f, where the last step began
  std::vector<int> pulled_;
  Eigen::VectorXd stiffening_;  ///< #B, springs beyond those of the energy
  Eigen::VectorXd compliance_;  ///< of the soft nodes: change of u for a change of load
};

}  // namespace relievo
