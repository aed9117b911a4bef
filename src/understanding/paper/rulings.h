#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Removes the lines of ruled or squared paper from a drawing (4 channels). These are five or more
/// thin lines at equal distances across most of the picture, horizontal or vertical up to a slope
/// of 0.1, and single lines across them, such as a margin. They may be bent, and are followed where
/// the drawing hides them. Their pixels take the colour of their darker side, unless they are so
/// dark that ink lies there. Returns an empty image where there are no rulings. O(pixels).
Image8 without_rulings(const Image8& drawing);

}  // namespace relievo::understanding
