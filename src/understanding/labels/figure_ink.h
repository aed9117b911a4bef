#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "understanding/areas/basins.h"
#include "understanding/labels/mark_pixels.h"

namespace relievo::understanding {

/// What strokes say of ink: pixels and the label that each stroke stands for.
struct InkVotes {
  std::vector<MarkedPixel> marks;
  std::vector<int> label_of_stroke;  ///< [strokes] 0 for the background
};

/// Gives the ink that lies on the background to the figure, so that nothing drawn is lost: the
/// outer half of outlines to the part that they bound, and strokes that bound nothing, as those of
/// a stick figure, a tail or a twig, to new parts, at least `thinnest_tube` wide, unless a stroke
/// says what they are. Specks, outlines of areas that strokes made background, and lines from edge
/// to edge of the picture, as of ruled paper, stay background. `labels` has the labels of all
/// pixels and is changed; new labels begin after `last_label`. O(pixels).
void take_ink(const Basins& basins, const InkVotes& votes, int last_label, Image<int32_t>& labels);

}  // namespace relievo::understanding
