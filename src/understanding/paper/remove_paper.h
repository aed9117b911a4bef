#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// The drawing laid on white: composited over it (over black and inverted where everything opaque
/// is light lines), the paper's colour and a slow change of light divided out. 8-bit RGB, 3
/// channels. `rgba` has 4. The light is a quadratic fitted to the bright part of each channel. A
/// pale figure `on_pure_white` can be that part: where paint would become white, nothing is divided
/// out. O(pixels).
Image8 remove_paper(const Image8& rgba, bool on_pure_white = false);

}  // namespace relievo::understanding
