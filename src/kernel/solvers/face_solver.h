#pragma once

#include <Eigen/Core>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/solvers/active_set.h"
#include "relievo/run_context.h"

namespace relievo {

/// Returns the largest magnitude of an entry; 0 where v is empty.
double max_norm(const Eigen::VectorXd& v);

/// Computes the gradient K z - b of the energy. O(entries of K).
Eigen::VectorXd gradient_at(const BoundQp& problem, const Eigen::VectorXd& z);

/// Minimises the energy on faces of the feasible set, one after another: the active unknowns are 0,
/// the others free. `at` holds the active set, the point z and, as mu, its gradient K z - b. All
/// arguments but the options outlive the solver.
class FaceSolver {
 public:
  FaceSolver(const BoundQp& problem, SparseCholesky& factor, const BoundQpOptions& options,
             const RunContext& context, BoundQpSolution& at);

  /// Finds the minimiser on the face of the active set, accurately enough to judge most guesses.
  /// `last`: this is likely to be the last face. Returns false where the matrix is not positive
  /// definite, or `context` is cancelled. One factorisation.
  bool solve(bool last);

  /// Returns whether the point is a sum of steps, with the round-off of each.
  bool is_rough() const { return rough_; }

  /// Removes that round-off: solves again for the point itself, or, where a start was given,
  /// computes its gradient again.
  void smooth();

  /// Refines the point iteratively, as long as that reduces the residual.
  void refine();

  /// Sets z_i to 0 and updates the gradient.
  void move_to_bound(int i);

  /// Returns -mu on free unknowns, 0 on active ones.
  Eigen::VectorXd free_residual() const;

 private:
  void solve_directly();
  void solve_change();
  Eigen::VectorXd large_free_residual() const;
  void clear_active(Eigen::VectorXd& v) const;

  const BoundQp& problem_;
  SparseCholesky& factor_;
  const RunContext& context_;
  double negligible_;  ///< residuals below it are neglected
  bool has_start_;     ///< a start was given
  bool rough_ = false;
  BoundQpSolution& at_;
};

}  // namespace relievo
