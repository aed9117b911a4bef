#pragma once

#include <cstdint>
#include <vector>

#include "understanding/labels/scribbles.h"

namespace relievo::understanding {

/// A pixel that a stroke covers.
struct StrokePixel {
  int32_t pixel = 0;  ///< y * width + x
  int stroke = 0;     ///< index into Scribbles::strokes
};

/// Finds the pixels of a width x height image whose centres the strokes cover, sorted by pixel.
/// Every point of a stroke covers at least the pixel in which it lies. Where strokes cross, the
/// later one counts. O(covered pixels log).
std::vector<StrokePixel> stroke_pixels(const Scribbles& scribbles, int width, int height);

}  // namespace relievo::understanding
