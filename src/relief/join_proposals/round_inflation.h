#pragma once

#include "kernel/image/mask.h"

namespace relievo {

/// The amount of inflation that makes an ellipse of these proportions as deep as it is narrow:
/// -c = laplace(c a^2 b^2 / (2 (a^2 + b^2)) (1 - x^2 / a^2 - y^2 / b^2)) with height b in the
/// middle, hence c = 2 (1 + (b / a)^2): 4 for a disc, 2 for a long limb.
/// O(box).
double round_inflation(const Mask& mask);

}  // namespace relievo
