#pragma once

#include <vector>

#include "relief/nonlinear/nonlinear_map.h"
#include "relief/nonlinear/nonlinear_solution.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// The inflation on the way.
struct KeptState {
  int step = 0;       ///< steps taken, from 1
  Eigen::VectorXd u;  ///< #N, scene units
};

/// An iteration and where it stands.
struct NonlinearRun {
  NonlinearState state;
  NonlinearReport report;
  std::vector<KeptState> kept;  ///< those that the options ask for
  std::vector<int> pulled;      ///< NonlinearMap::pulled where it converged
  bool once = false;            ///< does not begin again where it does not converge
};

/// Iterates contact and inflation under one set of pairs until they agree, from the run's state,
/// and leaves it there. Where that does not converge, begins again with other softnesses. Appends
/// the steps to the report and sets its status and residual; where nothing converges, leaves the
/// state as it was. Fails only when cancelled, or where the contact has no solution.
Status iterate_nonlinear(const NonlinearSystems& systems, const NonlinearOptions& options,
                         const RunContext& context, NonlinearRun& run);

}  // namespace relievo::relief
