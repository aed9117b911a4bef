#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/image.h"
#include "relievo/maps.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo {

/// Samples the relief at the centres of width x height pixels spread over the canvas. u and g are
/// interpolated and the root taken per pixel, so the maps are smooth at any resolution. A pixel
/// belongs to exactly one base triangle. Fails with usage or limit where a side is not in
/// [1, 32768] or there are more than 2^28 pixels, before memory is spent. O(pixels + triangles).
Result<ReliefMaps> rasterize_relief(const LayeredMesh& mesh, const Inflation& inflation,
                                    const Ordering& ordering, const Scene& scene, int width,
                                    int height, const RunContext& context = {});

/// How much of the light of an even sky each pixel of the front view receives, 0 to 1, 1 on the
/// background: the share of the hemisphere about its normal, weighted by the cosine, that the
/// heights within a fifth of the view's longer side leave open; in the outer half they fade.
/// Horizons are sought along eight lines through the pixel and integrated in closed form [Jimenez
/// et al. 2016, Practical real-time strategies for accurate indirect occlusion, eq. 7]. `pixel`:
/// canvas px per pixel of the maps. O(pixels * log of the longer side).
ImageF ambient_occlusion(const ReliefMaps& maps, double pixel);

}  // namespace relievo
