#pragma once

#include "relievo/image.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "understanding/labels/scribbles.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// Divides a flat drawing into its visible parts: calls find_basins, then label_basins, with their
/// errors. Where strokes change repeatedly, call these two and keep the basins.
Result<Segmentation> segment_drawing(const Drawing& drawing, const Scribbles& scribbles = {},
                                     const RunContext& context = {});

}  // namespace relievo::understanding
