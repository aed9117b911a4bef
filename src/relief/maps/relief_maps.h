#pragma once

#include "relief/surface/surface_sample.h"
#include "relievo/maps.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Samples the relief at the centres of width x height pixels spread over the canvas. u and g are
/// interpolated and the root taken per pixel, so the maps are smooth at any resolution. A pixel
/// belongs to exactly one base triangle. Fails with usage or limit, before memory is spent, if a
/// side is not in [1, 32768] or there are more than 2^28 pixels. O(pixels + triangles).
Result<ReliefMaps> rasterize_relief(const SolvedSurface& surface, int width, int height,
                                    const RunContext& context = {});

}  // namespace relievo::relief
