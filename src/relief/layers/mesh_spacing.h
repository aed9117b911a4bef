#pragma once

#include "relief/layers/layer_parts.h"
#include "relievo/result.h"

namespace relievo {

/// The spacing of outline samples: as given, or the one at which the joined mesh has about the
/// wanted number of nodes. Fails with `limit` where the mesh would certainly exceed max_nodes.
/// Costs a few samplings of the outlines, no triangulation; fails with `interrupted` where
/// `context` is cancelled.
Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context);

}  // namespace relievo
