#pragma once

#include <array>
#include <vector>

#include "kernel/meshing/size_field.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/sample_outlines.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Returns the spacing of outline samples, px: the given one, or that at which the joined mesh has
/// about the wanted number of nodes. Fails with `limit` if the mesh would certainly have more than
/// max_nodes, and with `interrupted` if `context` is cancelled. Costs a few samplings of the
/// outlines and no triangulation.
Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context);

/// Makes the field of wanted edge lengths around sampled outlines.
SizeField size_field_for(const SampledOutlines& sampled, double spacing);

/// Places points between the outlines, away from the edges by a fraction of the size there.
/// O(points + edges) for edges about as long as the size beside them.
std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges);

}  // namespace relievo::relief
