#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Lays a drawing (4 channels) on white, 3 channels. A transparent one is composited over white, or
/// inverted over white where all that is opaque is light lines. In an opaque one the colour of the
/// paper and a slow change of light are divided out: a quadratic in x and y, fitted to the bright
/// part of each channel. On pure white (`on_pure_white`) the bright part can be a pale figure, so
/// no light is divided out where paint would become white. O(pixels).
Image8 lay_on_white(const Image8& rgba, bool on_pure_white = false);

}  // namespace relievo::understanding
