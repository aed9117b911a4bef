#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// Returns the value `above` with opacity `alpha` (0 to 255) composited over `below`, rounded.
inline uint8_t lay_over(int above, int below, int alpha) {
  return static_cast<uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// Composites the RGBA pixel `above` over `below`, both with straight alpha. `opacity` in [0, 1]
/// multiplies the alpha of the one above.
void lay_over(uint8_t* below, const uint8_t* above, double opacity = 1);

/// Lays the whole of a picture over another, both RGBA with straight alpha, its left upper pixel at
/// (left, top). Precondition: it lies inside. O(pixels of `above`).
void lay_picture_over(Image8& below, int left, int top, const Image8& above, double opacity = 1);

/// Returns a value with opacity `alpha` (0 to 255) composited over white.
inline uint8_t on_paper(int colour, int alpha) { return lay_over(colour, 255, alpha); }

/// Returns the colour that, composited with opacity `alpha` in (0, 1] over white, gives `colour`.
inline uint8_t off_paper(double colour, double alpha) {
  return static_cast<uint8_t>(
      std::lround(std::clamp((colour - 255 * (1 - alpha)) / alpha, 0.0, 255.0)));
}

/// Returns the least alpha of a picture (4 channels). O(pixels).
uint8_t least_alpha(const Image8& rgba);

/// Copies `picture` into `canvas`, its first pixel to (left, top). Precondition: it lies inside the
/// canvas and has as many channels. O(pixels of the picture).
template <class T>
void paste(Image<T>& canvas, int left, int top, const Image<T>& picture) {
  const size_t row = static_cast<size_t>(picture.width) * picture.channels;
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(&picture.at(0, y), row, &canvas.at(left, top + y));
}

/// Returns whether the opaque pixels are light and few, as those of lines meant for a dark
/// background. `rgba` has 4 channels. O(pixels).
bool is_light_on_nothing(const Image8& rgba);

/// Computes the mean colour of each label of a drawing on white, 0 to 255 a channel, for the labels
/// 0 to the largest. Leaves out pixels less than 3 px from another label, where outlines run,
/// unless the label has no others. Precondition: `rgba` has the size of `labels`. O(pixels).
std::vector<std::array<double, 3>> label_colours(const Image8& rgba, const Image16& labels);

}  // namespace relievo
