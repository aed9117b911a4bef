#pragma once

#include <vector>

#include "relief/pipeline/build_relief.h"
#include "relievo/bytes.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::cli {

/// After which steps the surface is shown: closely at first, then ever farther apart.
std::vector<int> convergence_steps(int last);

/// The surfaces that the non-linear method passed through and the one it ended at, in clay, side
/// by side at one scale, as a PNG file.
Result<Bytes> draw_convergence(const Relief& relief, const Scene& scene, const RunContext& context);

}  // namespace relievo::cli
