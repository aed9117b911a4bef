#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "relief/nonlinear/nonlinear_map.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// An iteration and its present state.
struct NonlinearRun {
  NonlinearState state;
  NonlinearReport report;
  std::map<int, Eigen::VectorXd> kept;  ///< u (#N, scene units) after NonlinearOptions::snapshots
  std::vector<int> pulling;             ///< NonlinearMap::pulling at the end, if it converged
  bool single_attempt = false;          ///< whether to stop if the first step control fails
};

/// Iterates contact and inflation under one set of pairs from the run's state until the change of u
/// is below the tolerance. If that does not converge, tries again with other step controls. Appends
/// the steps to the report and sets its status and residual. If no attempt converges, the state is
/// that of the start. `bound` must be prepared. Fails only when cancelled, or if the contact has no
/// solution.
Status iterate_nonlinear(const InflationResponse& response, DepthSystem& depth, BoundaryStep& bound,
                         const NonlinearOptions& options, const RunContext& context,
                         NonlinearRun& run);

}  // namespace relievo::relief
