#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// An opaque drawing (4 channels) on pure white without a grey shadow on the ground below the
/// figure: a soft one, or one of one grey below a figure whose outlines are inked while nothing
/// bounds it. Nothing where there is none. O(pixels).
Image8 without_cast_shadow(const Image8& rgba);

}  // namespace relievo::understanding
