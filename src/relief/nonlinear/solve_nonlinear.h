#pragma once

#include <vector>

#include "relief/inflation/inflate.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/order_depth.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

constexpr double min_lambda_bnd = 1e-6;  ///< bounds of lambda_bnd
constexpr double max_lambda_bnd = 1e6;
constexpr double min_lambda_shift = 1e-3;  ///< bounds of lambda_shift
constexpr double max_lambda_shift = 100;   ///< the iteration need not converge above it

struct NonlinearOptions {
  double lambda_bnd = 0.01;  ///< weight of f^2 on B, in 1 / scene unit
  double lambda_shift = 1;   ///< weight of the shift against the inflation
  /// Cost of the shift. Limbs and caps are found in the inflation of the start.
  OrderingOptions ordering{.straight_limbs = false, .close_caps = false};
  InflationOptions bumps;      ///< for the bumps raised on the solution (raise_bumps)
  double tolerance = 1e-4;     ///< on the residual of the iteration
  int max_iterations = 150;    ///< of one attempt
  std::vector<int> snapshots;  ///< steps after which the surface is kept, ascending, from 1
};

/// Inflates and shifts all parts at once [P eq 3-6]: minimises
///   (M^-1 L u - c)' M (M^-1 L u - c) + lambda_bnd int_B f^2 ds + lambda_shift g'(L + epsilon M) g
/// over u and g, f = sgn(u) sqrt|u|, such that the heights f + g satisfy the depth pairs and u = 0
/// on outlines. B are the outlines under Robin ranges. Wanted shifts change the last term as in the
/// depth order. Starts from `start`, any inflation of the mesh, and from `known`, the end of a
/// similar problem or empty. `system` is as for order_depth, and both may share it. If the
/// iteration does not converge, returns the start, ordered, with the status iteration_limit. Fails
/// with usage for options out of range, as order_depth, and when cancelled.
Result<NonlinearSolution> solve_nonlinear(const SurfaceInput& surface, const Inflation& start,
                                          const NonlinearOptions& options,
                                          const NonlinearMemory& known, OrderingSystem& system,
                                          const RunContext& context = {});

}  // namespace relievo::relief
