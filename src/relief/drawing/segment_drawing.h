#pragma once

#include "relief/drawing/find_basins.h"
#include "relief/drawing/scribbles.h"
#include "relief/drawing/segmentation.h"
#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo {

/// Divides a flat drawing into its visible parts: find_basins, then label_basins. Where strokes
/// change again and again, call these two instead and keep the basins.
Result<Segmentation> segment_drawing(const Drawing& drawing, const Scribbles& scribbles = {},
                                     const RunContext& context = {});

}  // namespace relievo
