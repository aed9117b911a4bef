#pragma once

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Divides proposed regions at their necks (see find_neck), where head, limbs, tail and ears of a
/// figure grow out of it without a line. Returns whether there are any; then the basins have to be
/// measured again. O(pixels), and the square of contours at a fixed resolution.
bool cut_necks(Basins& basins);

}  // namespace relievo::understanding
