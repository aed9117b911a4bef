#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/solvers/symmetric_graph.h"

namespace relievo {

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
