#pragma once

#include <vector>

#include "relievo/image.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// The pieces of the boundaries between labels along which neither side lies on a line or edge
/// (`barrier` 0), as polylines within 1 px. Those shorter than the lines are wide are noise and
/// left out. O(pixels).
std::vector<Bridge> find_bridges(const Image16& labels, const Image8& barrier, double line_width);

}  // namespace relievo::understanding
