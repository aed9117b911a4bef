#pragma once

#include "relievo/image.h"

namespace relievo::relief {

/// Continues the paint of each part under its contours. A pixel of ink takes the colour opposite
/// the nearest pixel of paint of its part, as if that were a mirror: so grain goes on and does not
/// become streaks. `front`: the part seen at every pixel, counted from 1, or 0. `ink`: 1 on
/// contours. Pixels beyond the outline take such colours where `near` is not 0. Pixels of parts
/// that show no paint stay. O(pixels).
void cover_ink(const Image16& front, const Image8& ink, const Image8& near, Image8& rgba);

}  // namespace relievo::relief
