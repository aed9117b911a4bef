#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/cholesky/symmetric_graph.h"
#include "kernel/solvers/bound_qp.h"
#include "relievo/run_context.h"

namespace relievo {

/// The largest magnitude; 0 where v is empty.
double max_norm(const Eigen::VectorXd& v);

/// K z - b.
Eigen::VectorXd gradient_at(const BoundQp& problem, const Eigen::VectorXd& z);

/// Minimises where the active bounds are 0, on one face of the bounds after another. `at` holds the
/// active bounds and the point, whose gradient is mu; it outlives the solver, as all arguments but
/// the options do.
class FaceSolver {
 public:
  FaceSolver(const BoundQp& problem, SparseCholesky& factor, const BoundQpOptions& options,
             const RunContext& context, BoundQpSolution& at);

  /// Accurate enough to judge most guesses; `last` where this is likely to be the last face. False
  /// where the matrix is not positive definite, or cancelled.
  bool solve(bool last);

  /// Whether the point is what a sequence of changes has left.
  bool is_rough() const { return rough_; }

  /// Ends that: by the same operations wherever the point came from, unless one was given.
  void smooth();

  /// Iterative refinement, as long as it reduces the residual.
  void refine();

  /// z_i := 0; mu stays the gradient.
  void move_to_bound(int i);

  /// -mu where nothing is active, 0 elsewhere.
  Eigen::VectorXd free_residual() const;

 private:
  void solve_directly();
  void solve_change();
  Eigen::VectorXd large_free_residual() const;
  bool factorise();
  void clear_active(Eigen::VectorXd& v) const;

  const BoundQp& problem_;
  SparseCholesky& factor_;
  const RunContext& context_;
  double negligible_;  ///< residuals that need no attention
  bool same_matrix_;
  bool goes_on_;  ///< from a point that was given
  bool rough_ = false;
  BoundQpSolution& at_;
};

/// A point of a bound-constrained quadratic program with its gradient K z - b.
struct BoundQpPoint {
  const SparseMatrix& K;                ///< n x n, lower triangle with the whole diagonal
  const SymmetricGraph& graph;          ///< of K
  const std::vector<uint8_t>& bounded;  ///< n: z_i >= 0
  const std::vector<uint8_t>& fixed;    ///< n: z_i = 0, or empty
  const Eigen::VectorXd& z;             ///< n
  const Eigen::VectorXd& gradient;      ///< n
};

/// Unknowns with what is guessed of them.
struct ActiveGuess {
  std::vector<int> unknowns;    ///< bounded ones, ascending
  std::vector<uint8_t> active;  ///< of each, 1 where its bound will hold with equality
};

/// Guesses the active bounds around some unknowns, `seeds`: all within a few steps in the graph of
/// K that are not fixed are relaxed by projected Gauss-Seidel sweeps to and fro, the others held;
/// by more sweeps the fewer they are. A step of a primal-dual active set moves the border of a
/// contact by one gap where the sweeps move it as far as its neighbourhood tells; the combination
/// is a truncated non-smooth Newton method (Graeser and Kornhuber 2009). O(n + sweeps * entries
/// around the seeds).
ActiveGuess relax_around(const std::vector<int>& seeds, const BoundQpPoint& point);

}  // namespace relievo
