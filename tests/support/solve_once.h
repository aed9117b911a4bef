#pragma once

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relief/ordering/order_depth.h"

namespace relievo::relief {

// The stages for one use: each call makes the discretisation and the system that it solves with.

inline Result<Inflation> inflate(const LayeredMesh& mesh, const Scene& scene,
                                 const InflationOptions& options, const RunContext& context = {}) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  PoissonSystem system(mesh, discretisation, Refactorisation::complete, context);
  return inflate({mesh, discretisation, scene}, options, system, context);
}

inline Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                                    const Scene& scene, const OrderingOptions& options,
                                    const RunContext& context = {}) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  OrderingSystem system;
  return order_depth({mesh, discretisation, scene}, inflation, options, system, context);
}

inline Result<NonlinearSolution> solve_nonlinear(const LayeredMesh& mesh, const Scene& scene,
                                                 const Inflation& start,
                                                 const NonlinearOptions& options,
                                                 const RunContext& context = {}) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  OrderingSystem system;
  return solve_nonlinear({mesh, discretisation, scene}, start, options, {}, system, context);
}

}  // namespace relievo::relief
