#pragma once

#include <array>
#include <vector>

#include "kernel/meshing/size_field.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/sample_outlines.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The spacing of outline samples: as given, or the one at which the joined mesh has about the
/// wanted number of nodes. Fails with `limit` where the mesh would certainly exceed max_nodes.
/// Costs a few samplings of the outlines, no triangulation; fails with `interrupted` where
/// `context` is cancelled.
Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context);

/// The wanted edge length around sampled outlines.
SizeField size_field_for(const SampledOutlines& sampled, double spacing,
                         const LayerOptions& options);

/// Points between the outlines, clear of the edges by a fraction of the size there.
/// O(points + edges) for edges about as long as the size beside them.
std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges);

}  // namespace relievo::relief
