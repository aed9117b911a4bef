#pragma once

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"

namespace relievo {

/// The pixels of a width x height canvas whose centres are inside the outline by the non-zero
/// rule. O(points + crossed rows + box).
Mask fill_outline(const Outline& outline, int width, int height);

}  // namespace relievo
