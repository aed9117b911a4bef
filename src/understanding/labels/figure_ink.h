#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "understanding/areas/basins.h"
#include "understanding/labels/stroke_pixels.h"

namespace relievo::understanding {

/// Gives the ink on the background to the figure, so that nothing drawn is lost. The outer half of
/// outlines goes to the part that they bound. Loose lines, which bound nothing, such as a stick
/// figure, a tail or a twig, become new parts (tubes) at least 1 % of the figure wide, unless a
/// stroke gives them to a part. Specks become part of the part that they touch. Outlines of areas
/// that strokes made background, and lines from edge to edge of the picture, stay background.
/// `labels` has the labels of all pixels and is changed; new labels follow `last_label`. `marks`
/// are the pixels of the strokes. O(pixels).
void take_ink(const Basins& basins, const Scribbles& scribbles,
              const std::vector<StrokePixel>& marks, int last_label, Image<int32_t>& labels);

}  // namespace relievo::understanding
