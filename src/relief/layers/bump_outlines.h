#pragma once

#include <vector>

#include "relief/layers/boundaries.h"

namespace relievo {

/// The outlines of all bumps. Beside a join they come loose for its length, or half of the way to
/// the next one; ranges of the scene replace those that they touch. Adds these ranges to `ramps`.
/// Near-linear in the length of the outlines.
std::vector<BumpNode> find_bump_outlines(const SheetMesh& mesh, const Scene& scene,
                                         const std::vector<LoopRun>& robin_runs,
                                         std::vector<RobinRamp>& ramps);

}  // namespace relievo
