#pragma once

#include <array>
#include <vector>

#include "kernel/meshing/size_field.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/sample_outlines.h"

namespace relievo {

/// The wanted edge length around sampled outlines.
SizeField size_field_for(const SampledOutlines& sampled, double spacing,
                         const LayerOptions& options);

/// Points between the outlines, clear of the edges by a fraction of the size there.
/// O(points + edges) for edges about as long as the size beside them.
std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges);

}  // namespace relievo
