#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "relievo/run_context.h"

namespace relievo {

/// The problem of minimising 1/2 z'Kz - b'z subject to z_i >= 0 where bounded[i] and z_i = 0 where
/// fixed[i]. K is symmetric positive definite.
struct BoundQp {
  SparseMatrix K;                ///< n x n, lower triangle with the whole diagonal
  Eigen::VectorXd b;             ///< n, finite
  std::vector<uint8_t> bounded;  ///< n, 0 or 1
  std::vector<uint8_t> fixed;    ///< n, 0 or 1, never both 1; empty: none
};

struct BoundQpOptions {
  std::vector<uint8_t> start_active;  ///< n: bounds first guessed to be active; empty: none
  /// n, a point near the minimiser, 0 where fixed: the solver computes the difference from it.
  /// Without a start (empty) the result depends on the problem and its active set alone, to the
  /// last bit.
  Eigen::VectorXd start;
  Eigen::VectorXd start_gradient;  ///< n, K start - b, if known; or empty
  /// Whether the residual of the free unknowns is computed and refined at the end, where there is a
  /// start. Without it the residual is taken from `start_gradient`, and as 0 after a solve, so that
  /// round-off adds up over a sequence of programs.
  bool refine = true;
  int max_iterations = 500;
  /// A bound is on the wrong side where z or mu is below -tolerance * max(1, |b|).
  double tolerance = 1e-13;
};

/// The outcome of a solver.
enum class SolveStatus { solved, iteration_limit, not_positive_definite, interrupted };

/// Statistics of a solution. Residuals are in the units of the problem, in the maximum norm,
/// divided by max(1, |b|).
struct BoundQpReport {
  SolveStatus status = SolveStatus::solved;
  int iterations = 0;
  int factorisations = 0;
  int safeguard_steps = 0;     ///< iterations of the safeguard that ends cycles
  int active = 0;              ///< number of active bounds
  double stationarity = 0;     ///< max |K z - b - mu|
  double primal = 0;           ///< worst violation of z >= 0
  double dual = 0;             ///< worst violation of mu >= 0
  double complementarity = 0;  ///< max |z mu| over the bounds
  double energy = 0;           ///< 1/2 z'Kz - b'z
};

/// The minimiser z, exactly 0 where active and never negative on other bounds, with K z - b = mu.
struct BoundQpSolution {
  Eigen::VectorXd z;            ///< n
  Eigen::VectorXd mu;           ///< n, multipliers, 0 where not active
  Eigen::VectorXd gradient;     ///< n, K z - b, mu up to round-off
  std::vector<uint8_t> active;  ///< n, 1 where fixed or the bound is active
  BoundQpReport report;
};

/// Solves a bound-constrained quadratic program by a primal-dual active set method. The solution
/// satisfies the KKT conditions
///   K z - b = mu,  z >= 0,  mu >= 0,  z mu = 0   on bounds,   K z = b   on free unknowns.
/// Each iteration
///   1. sets the guessed active bounds to 0 (their rows and columns become those of the identity,
///   so
///      that the pattern never changes) and solves for the other unknowns;
///   2. collects the bounds on the wrong side, z < 0 or mu < 0, and ends if there are none;
///   3. guesses the active bounds around them by local relaxation (relax_around). Where their
///   number
///      did not fall, they change sides instead (block pivoting, Judice and Pires 1994).
/// Where their number does not fall several times in a row, a safeguard takes over that lowers the
/// energy in each iteration: it moves along projected directions from face to face (More and
/// Toraldo 1991, with exact solutions on the faces). Both together end after finitely many
/// iterations. Iterative refinement keeps the residuals of the report near round-off.
///
/// Precondition: `factor` has analysed the pattern of K incrementally. It holds the last factor
/// afterwards. One factorisation an iteration; checks `context` before each.
BoundQpSolution solve_bound_qp(const BoundQp& problem, SparseCholesky& factor,
                               BoundQpOptions options = {}, const RunContext& context = {});

}  // namespace relievo
