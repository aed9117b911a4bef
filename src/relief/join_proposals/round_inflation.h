#pragma once

#include "kernel/image/mask.h"

namespace relievo {

/// The amount of inflation that makes an ellipse of these proportions as deep as it is narrow:
/// -c = laplace(c a^2 b^2 / (2 (a^2 + b^2)) (1 - x^2 / a^2 - y^2 / b^2)) with height b in the
/// middle, hence c = 2 (1 + (b / a)^2): 4 for a disc, 2 for a long limb.
/// O(box).
double round_inflation(const Mask& mask);

/// By what c is multiplied of a feature that takes a share q of what it lies on: 0.4 (1 - 1.5
/// sqrt(q)), at least 0.02. Features bulge half as much as balls, as the eyes, noses and flowers
/// of the samples do by their authors (c is 0.3 of round in the median), and the less the larger
/// they are: a patch on a belly hardly does.
double feature_inflation(double share);

}  // namespace relievo
