#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/joint/joint_map.h"
#include "relief/joint/joint_solution.h"
#include "relief/joint/solve_jointly.h"

namespace relievo {

/// The inflation on the way.
struct KeptState {
  int step = 0;       ///< steps taken, from 1
  Eigen::VectorXd u;  ///< #N, scene units
};

/// An iteration that may go on under other pairs.
struct JointRun {
  JointState state;
  std::vector<uint8_t> closed;  ///< gaps of the problem that are closed in the first guess
  JointReport report;
  BoundModes modes;             ///< that the steps follow; those found, where the options ask
  std::vector<KeptState> kept;  ///< those that the options ask for
  /// Asked once the residual is below `rough`, with the heights: whether the pairs do not suffice,
  /// so that there is no use in going on.
  std::function<bool(const std::vector<double>& h)> crosses;
  bool crossed = false;  ///< its answer
  /// The depth order under the pairs as the contact has left it, where it was that.
  std::optional<DepthSystem> order;
};

/// Iterates contact and inflation under one set of pairs until they agree, from the run's state,
/// and leaves it there. Where that does not converge, begins again with other softnesses. Appends
/// the steps to the report and sets its status and residual; where nothing converges, leaves the
/// state as it was. Ends early where heights cross. Fails only when cancelled, or where the contact
/// has no solution.
Status iterate_jointly(const InflationResponse& response, const DepthProblem& problem,
                       const JointOptions& options, const RunContext& context, JointRun& run);

}  // namespace relievo
