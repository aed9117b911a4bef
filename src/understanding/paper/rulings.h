#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// A drawing (4 channels) without the lines of ruled or squared paper, or nothing where there are
/// none: five or more thin ones at equal distances across most of the picture, level or upright to
/// a tenth, and what crosses them likewise, as a margin. They are followed through what hides them,
/// and may be bent. Their pixels take the colour of their darker side, unless they are so dark that
/// ink lies there. O(pixels).
Image8 without_rulings(const Image8& drawing);

}  // namespace relievo::understanding
