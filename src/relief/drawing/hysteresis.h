#pragma once

#include "relievo/image.h"

namespace relievo {

/// 1 where `values` (one channel) reach `low` and hang together, over sides and corners, with a
/// pixel that reaches `high`; 0 elsewhere. O(pixels).
Image8 connected_above(const Image8& values, int low, int high);

}  // namespace relievo
