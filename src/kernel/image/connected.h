#pragma once

#include "kernel/image/mask.h"

namespace relievo {

/// The pixels of `mask` that are 4-connected within it to a pixel of `seed`. O(box).
Mask connected_to(const Mask& mask, const Mask& seed);

}  // namespace relievo
