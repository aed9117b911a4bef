#pragma once

#include "relievo/image.h"

namespace relievo {

/// Whether the opaque pixels are light and few: lines meant for a dark ground. `rgba` has 4
/// channels. O(pixels).
bool is_light_on_nothing(const Image8& rgba);

}  // namespace relievo
