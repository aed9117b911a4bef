#pragma once

#include "benchmarks/references/lagrange_active_set.h"
#include "kernel/solvers/active_set.h"

namespace relievo::benchmarks {

/// Solves the program by a primal-dual interior-point method with Mehrotra's predictor and
/// corrector. Each step takes one factorisation by SparseCholesky, on one pattern, and two solves.
/// Stops where residual and complementarity are below 1e-10.
ReferenceSolution solve_by_interior_point(const BoundQp& program, std::span<const int> order);

}  // namespace relievo::benchmarks
