#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/image.h"

namespace relievo {

/// The sub-pixel outlines of labels, in drawing px: [label] for 0 to the largest label, where [0]
/// stays empty. Rings are smooth, run along the middle of lines where `ink` (darkness, 255 full;
/// may be empty) has some, and are closed along the edge of the image. The boundary of two labels
/// has the same points in both outlines. `line_width` is how wide lines are, px. Rings at even
/// nesting depth have positive area. O(pixels).
std::vector<Outline> label_outlines(const Image16& labels, const Image8& ink = {},
                                    double line_width = 1);

}  // namespace relievo
