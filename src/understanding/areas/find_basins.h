#pragma once

#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "understanding/areas/basins.h"
#include "understanding/perception/network.h"

namespace relievo::understanding {

/// Divides a drawing into basins by the watershed of the distance to its lines, and proposes which
/// of them make one part. Errors: `bad_input` where the drawing is empty or has no lines or areas,
/// `interrupted`. Near-linear in pixels. Cancellation is checked between steps, the longest of
/// which takes a third of the time.
Result<Basins> find_basins(const Drawing& drawing, const Network& network,
                           const RunContext& context = {});

}  // namespace relievo::understanding
