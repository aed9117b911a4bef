#pragma once

#include "io/svg/svg_reading.h"

namespace relievo {

/// Adds a region that cuts what is inside to the drawing and to `around`.
void add_clip(Region region, InheritedState& around, Reading& reading);

/// Adds the clip path and the mask that the style around states. A mask cuts where it is
/// lighter than half, or more than half opaque where its mask-type is alpha.
void enter_clips(InheritedState& around, Reading& reading);

}  // namespace relievo
