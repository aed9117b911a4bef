#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/image/mask.h"
#include "relievo/image.h"

namespace relievo {

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

/// The pairs of labels, smaller one first, along most of whose common border the drawing shows
/// nothing, neither a line nor a change of colour: what they are of has grown together there.
/// `rgba` has the size of `labels`. O(pixels).
std::vector<std::pair<uint16_t, uint16_t>> open_borders(const Image8& rgba, const Image16& labels);

}  // namespace relievo
