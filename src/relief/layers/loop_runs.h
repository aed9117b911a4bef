#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/connect_sheets.h"
#include "relief/layers/sample_outlines.h"

namespace relievo {

/// Where runs of outline samples lie in the spliced loops; loop -1 where a run has collapsed.
/// O(runs * length of their loops).
std::vector<LoopRun> locate_runs(const SplicedCurves& spliced, const std::vector<CurveRun>& runs);

/// The joins of the scene as paths of base vertices. Fails with bad_input naming the join.
Result<std::vector<JoinPath>> join_paths(const Scene& scene, const SplicedCurves& spliced,
                                         const std::vector<LoopRun>& runs);

}  // namespace relievo
