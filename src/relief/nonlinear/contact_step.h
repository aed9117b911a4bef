#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/solvers/active_set.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/ordering/depth_system.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// The depth order for a given inflation, and the forces of the depth pairs.
struct Contact {
  SolveStatus status = SolveStatus::solved;
  int factorisations = 0;
  Eigen::VectorXd change;   ///< #F, change of f at the free nodes
  Eigen::VectorXd force;    ///< #N, q = lambda_shift (A g - b), 0 where nothing touches
  double shift_energy = 0;  ///< lambda_shift times twice the cost of g
};

/// Solves the depth order for a given f, and for f itself at some free nodes F, where the inflation
/// resists with a stiffness. Pattern, factor and active set are kept from one step to the next.
/// Without free nodes it is the depth order of `depth`.
class ContactStep {
 public:
  /// Starts from the active set of `depth`. Without free nodes it works on the program and factor
  /// of `depth` and leaves the last active set there. `free`: the nodes F.
  ContactStep(const NonlinearModel& model, DepthSystem& depth, const std::vector<int>& free);

  /// Analyses the matrix if there are free nodes. Returns false if `context` is cancelled.
  bool prepare(const RunContext& context);

  /// Minimises lambda_shift (cost of g) + sum over F of 1/2 stiffness y^2 - linear y under the
  /// depth pairs, y the change of f. `f`: #N, scene units; `stiffness`, positive, and `linear`: #F.
  /// Precondition: prepared. Factorises what the active set changes.
  Contact solve(const Eigen::VectorXd& f, const Eigen::VectorXd& stiffness,
                const Eigen::VectorXd& linear, const RunContext& context);

  /// Returns the heights of the last solution, px, #N.
  std::vector<double> heights() const;

 private:
  void make_free_program(const std::vector<int>& free);
  void start_at_zero();
  Contact solve_free(const Eigen::VectorXd& f, const Eigen::VectorXd& stiffness,
                     const Eigen::VectorXd& linear, const RunContext& context);
  Contact solve_fixed(const Eigen::VectorXd& f, const RunContext& context);
  Eigen::VectorXd gradient_for(const Eigen::VectorXd& f) const;
  void open_for(const Eigen::VectorXd& f);
  bool is_closed(const DepthGap& gap) const;
  double rise_over_parent(const DepthGap& gap, const Eigen::VectorXd& f) const;

  const NonlinearModel& model_;
  DepthSystem& depth_;
  bool has_free_;
  ShiftMatrix matrix_;        ///< only with free nodes
  DepthSystem free_;          ///< only with free nodes: the program over (z, y), no forest
  Eigen::VectorXd z_;         ///< last solution, or start; initially empty with free nodes
  Eigen::VectorXd gradient_;  ///< K z - b there, only without free nodes
  Eigen::VectorXd f_;         ///< #N, f of the last solution, scene units
};

}  // namespace relievo::relief
