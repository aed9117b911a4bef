#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "relievo/run_context.h"

namespace relievo {

/// Minimise 1/2 z'Kz - b'z subject to z_i >= 0 where bounded[i] and z_i = 0 where fixed[i]. K is
/// positive definite.
struct BoundQp {
  SparseMatrix K;                ///< n x n, lower triangle with the whole diagonal
  Eigen::VectorXd b;             ///< n, finite
  std::vector<uint8_t> bounded;  ///< n, 0 or 1
  std::vector<uint8_t> fixed;    ///< n, 0 or 1, not where bounded; empty: none
};

struct BoundQpOptions {
  std::vector<uint8_t> start_active;  ///< n: bounds first taken to hold with equality; empty: none
  bool same_matrix = false;           ///< K is the one that the factor was last computed of
  /// n, a point near the minimiser, 0 where fixed: only what is different from it is solved for.
  /// Empty: none; the result then depends on the problem and its active set alone, to the last bit.
  Eigen::VectorXd start;
  Eigen::VectorXd start_gradient;  ///< n, K start - b, if known; or empty
  /// Whether the residual of the free unknowns is computed at the end, and refined. Where not, it
  /// is taken to be what `start_gradient` says and 0 after a solve: round-off adds up.
  bool refine = true;
  ForwardSweep sweep;  ///< of the last solution with this factor, which may save repeating it
  int max_iterations = 500;
  /// A bound changes sides when z or mu is below -tolerance * max(1, |b|).
  double tolerance = 1e-13;
};

enum class SolveStatus { solved, iteration_limit, not_positive_definite, interrupted };

/// How a bound-constrained quadratic program was solved. Residuals are in the units that the
/// solver was given (scene units), in the maximum norm relative to max(1, |b|).
struct BoundQpReport {
  SolveStatus status = SolveStatus::solved;
  int iterations = 0;
  int factorisations = 0;
  int safeguard_steps = 0;     ///< iterations of the safeguard that ends cycles
  int active = 0;              ///< bounds that hold with equality
  double stationarity = 0;     ///< max |K z - b - mu|
  double primal = 0;           ///< worst violation of z >= 0
  double dual = 0;             ///< worst violation of mu >= 0
  double complementarity = 0;  ///< max |z mu| over the bounds
  double energy = 0;           ///< 1/2 z'Kz - b'z
};

/// The minimiser, exactly 0 where active and never negative on other bounds; K z - b = mu.
struct BoundQpSolution {
  Eigen::VectorXd z;            ///< n
  Eigen::VectorXd mu;           ///< n, multipliers: 0 but where active
  Eigen::VectorXd gradient;     ///< n, K z - b; what differs from mu is round-off
  std::vector<uint8_t> active;  ///< n, 1 where fixed and where the bound holds with equality
  ForwardSweep sweep;           ///< of the last direct solve
  BoundQpReport report;
};

/// Primal-dual active set: every iteration fixes the guessed active bounds to 0 (their rows and
/// columns become the identity, so the pattern never changes), solves for the rest and guesses anew
/// around all bounds with the wrong sign, by local relaxation; where their number did not fall,
/// they change sides instead (block pivoting, Judice and Pires 1994). Where it does not fall four
/// times in a row, a safeguard takes over that lowers the energy in every iteration, moving along
/// projected directions from face to face (as More and Toraldo 1991 do, with exact solutions on the
/// faces); both together end after finitely many iterations. Refines iteratively, so that the
/// residuals of the report stay near round-off. `factor` must have analysed the pattern of K
/// incrementally, and holds the last factor afterwards. Watches `context` between factorisations,
/// of which every iteration takes one.
BoundQpSolution solve_bound_qp(const BoundQp& problem, SparseCholesky& factor,
                               BoundQpOptions options = {}, const RunContext& context = {});

}  // namespace relievo
