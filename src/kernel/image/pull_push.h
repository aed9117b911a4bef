#pragma once

#include "relievo/image.h"

namespace relievo {

/// Fills unknown pixels smoothly from known ones: each takes the colour of the finest mean around
/// it that is known (pull-push; Gortler et al., The Lumigraph, 1996, section 3.4). The last channel
/// of `colours` is the weight in [0, 1]: 0 unknown, 1 known. Returns the other channels, 0 where
/// nothing is known at all. O(values).
ImageF pull_push(const ImageF& colours);

}  // namespace relievo
