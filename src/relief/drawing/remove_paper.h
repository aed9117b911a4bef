#pragma once

#include "relievo/image.h"

namespace relievo {

/// The drawing on pure white: composited over white (over black and inverted where everything
/// opaque is light lines), the paper's colour and a slow change of light divided out. 8-bit RGB,
/// 3 channels. `rgba` has 4. The light is a quadratic fitted to the bright part of each channel.
/// O(pixels).
Image8 remove_paper(const Image8& rgba);

}  // namespace relievo
