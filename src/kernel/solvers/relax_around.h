#pragma once

#include <vector>

#include "kernel/cholesky/symmetric_graph.h"
#include "kernel/solvers/bound_qp.h"

namespace relievo {

/// Guesses the active bounds around the unknowns `seeds`: writes at.active, given at.z and, in
/// at.mu, the gradient K z - b. `graph` is that of K.
///
/// Relaxes all unknowns within a few steps of the seeds in the graph by projected Gauss-Seidel
/// sweeps in both directions,
///   z_i := max(0, z_i - g_i / K_ii)   (without the maximum where i is not bounded),
/// while the others are fixed; the fewer unknowns, the more sweeps. A step of a primal-dual active
/// set moves the border of a contact by one gap; the sweeps move it as far as the values around it
/// imply. Both together are a truncated non-smooth Newton method (Graeser and Kornhuber 2009).
/// O(n + sweeps * entries around the seeds).
void relax_around(const std::vector<int>& seeds, const BoundQp& problem,
                  const SymmetricGraph& graph, BoundQpSolution& at);

}  // namespace relievo
