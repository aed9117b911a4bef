#pragma once

#include "kernel/image/image.h"

namespace relievo {

/// The artist's drawing as pixels: 8-bit sRGB with straight alpha, 4 channels. Covers the whole
/// canvas of the scene; its resolution may differ from the canvas size. Empty when there is none.
struct Drawing {
  Image8 rgba;
};

}  // namespace relievo
