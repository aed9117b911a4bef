#pragma once

#include <array>
#include <vector>

#include "kernel/image/mask.h"
#include "relievo/image.h"

namespace relievo::understanding {

/// By how much outlines towards the background lie outside the middle of their ink, px: parts hold
/// the ink of their outline there, while they meet each other in its middle. Half of the median
/// width of what is dark, beside the mean `colours` of the labels (see label_colours), from the
/// background inwards; 0 where that is nothing. `rgba` has the size of `labels`. O(pixels).
double rim_width(const Image8& rgba, const Image16& labels,
                 const std::vector<std::array<double, 3>>& colours);

/// The labels without a rim of this width towards the background, but for what is too narrow to
/// have one; every label remains. O(pixels).
Image16 without_rim(const Image16& labels, double rim);

/// What is in either. O(boxes).
Mask united(const Mask& a, const Mask& b);

}  // namespace relievo::understanding
