#pragma once

#include "kernel/base/result.h"
#include "kernel/base/run_context.h"
#include "relief/joint/joint_map.h"
#include "relief/joint/joint_solution.h"
#include "relief/joint/solve_jointly.h"

namespace relievo {

/// Iterates contact and inflation under one set of pairs until they agree, from `state`, and
/// leaves it there. Where that does not converge, begins again with other softnesses. Appends the
/// steps to `report` and sets its status and residual; where nothing converges, leaves `state` as
/// it was. Fails only when cancelled, or where the contact has no solution.
Status iterate_jointly(const InflationResponse& response, const DepthProblem& problem,
                       const JointOptions& options, const RunContext& context, JointState& state,
                       JointReport& report);

}  // namespace relievo
