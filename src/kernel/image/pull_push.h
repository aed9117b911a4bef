#pragma once

#include "relievo/image.h"

namespace relievo {

/// Fills what is unknown smoothly from what is known: each pixel takes the colour of the finest
/// mean around it that knows one (pull-push; Gortler et al., The Lumigraph, 1996, section 3.4).
/// `colours` has any channels, the last one the weight in [0, 1]: 0 unknown, 1 known. Returns the
/// others; 0 everywhere where nothing is known. O(values).
ImageF pull_push(const ImageF& colours);

}  // namespace relievo
