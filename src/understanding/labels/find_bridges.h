#pragma once

#include <vector>

#include "relievo/image.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// Finds the pieces of the boundaries between labels that run far from lines and edges, as
/// polylines within 1 px. Pieces shorter than lines are wide are noise and left out. `barrier` and
/// `line_width`, px, are those of a LineMap. O(pixels).
std::vector<Bridge> find_bridges(const Image16& labels, const Image8& barrier, double line_width);

}  // namespace relievo::understanding
