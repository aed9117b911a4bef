#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflate.h"
#include "relief/layers/layered_mesh.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/ordering/order_depth.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

constexpr double min_lambda_bnd = 1e-6;  ///< bounds of lambda_bnd
constexpr double max_lambda_bnd = 1e6;
constexpr double min_lambda_shift = 1e-3;  ///< bounds of lambda_shift
constexpr double max_lambda_shift = 100;   ///< above it the iteration need not converge

struct NonlinearOptions {
  double lambda_bnd = 0.01;           ///< pull of B to the drawing plane, in scene units
  double lambda_shift = 1;            ///< weight of the shift against the inflation
  double epsilon = 1e-4;              ///< weight of the pull to g = 0, in scene units
  WantedShifts wanted{false, false};  ///< by the inflation of the start
  InflationOptions bumps;             ///< by which bumps are raised on the solution (raise_bumps)
  double tolerance = 1e-4;            ///< on the residual of the iteration
  int max_iterations = 150;           ///< of one attempt
  int anderson_depth = 16;
  std::vector<int> snapshots;  ///< after which steps the surface is kept, ascending, from 1
};

/// Inflates and shifts all parts at once [P eq 3-6]: minimises
///   (M^-1 L u - c)' M (M^-1 L u - c) + lambda_bnd int_B f^2 ds + lambda_shift g'(L + epsilon M) g
/// over u and g, f = sgn(u) sqrt|u|, where the heights f + g obey the depth pairs, u = 0 on
/// outlines, and B are the outlines under Robin ranges; the last term with leans and limbs as in
/// the depth order. Begins from the inflation of the input, any of the mesh, and from what is known
/// of a similar problem. `system` is as for order_depth, which may prepare it and go on with it.
Result<NonlinearSolution> solve_nonlinear(const OrderingInput& input,
                                          const NonlinearOptions& options,
                                          const NonlinearMemory& known, OrderingSystem& system,
                                          const RunContext& context = {});

/// The same with operators for one use.
Result<NonlinearSolution> solve_nonlinear(const LayeredMesh& mesh, const Scene& scene,
                                          const Inflation& start, const NonlinearOptions& options,
                                          const RunContext& context = {});

}  // namespace relievo::relief
