#pragma once

#include <vector>

#include "relief/joint/joint_map.h"
#include "relief/joint/joint_solution.h"
#include "relief/joint/solve_jointly.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// The inflation on the way.
struct KeptState {
  int step = 0;       ///< steps taken, from 1
  Eigen::VectorXd u;  ///< #N, scene units
};

/// An iteration and where it stands.
struct JointRun {
  JointState state;
  JointReport report;
  std::vector<KeptState> kept;  ///< those that the options ask for
  std::vector<int> pulled;      ///< JointMap::pulled where it converged
  bool once = false;            ///< does not begin again where it does not converge
};

/// Iterates contact and inflation under one set of pairs until they agree, from the run's state,
/// and leaves it there. Where that does not converge, begins again with other softnesses. Appends
/// the steps to the report and sets its status and residual; where nothing converges, leaves the
/// state as it was. Fails only when cancelled, or where the contact has no solution.
Status iterate_jointly(const JointSystems& systems, const JointOptions& options,
                       const RunContext& context, JointRun& run);

}  // namespace relievo
