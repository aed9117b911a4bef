#pragma once

#include "relievo/image.h"

namespace relievo::relief {

/// Copies three channels from known pixels to the others, to each from about the nearest in
/// Chebyshev distance: two passes over the pixels, each looking at the neighbours before it.
void spread_colours(const Image8& known, Image8& colours);

}  // namespace relievo::relief
