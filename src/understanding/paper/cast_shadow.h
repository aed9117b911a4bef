#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Paints the grey shadow below a figure white, in an opaque drawing (4 channels) on pure white. A
/// soft shadow fades into the page. A hard one is of one grey, without an outline, below a figure
/// whose outlines are inked. Returns an empty image where there is no shadow. O(pixels).
Image8 without_cast_shadow(const Image8& rgba);

}  // namespace relievo::understanding
