#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"

namespace relievo {

/// What is seen of `below` through `above` of this opacity (255: nothing), rounded.
inline uint8_t lay_over(int above, int below, int alpha) {
  return static_cast<uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// Lays a pixel over another, RGBA with straight alpha both; `opacity` in [0, 1] is a factor to the
/// alpha of the one above.
void lay_over(uint8_t* below, const uint8_t* above, double opacity = 1);

/// Lays the whole of a picture over another, both RGBA with straight alpha, its left upper pixel at
/// (left, top). Precondition: it lies inside. O(pixels of `above`).
void lay_picture_over(Image8& below, int left, int top, const Image8& above, double opacity = 1);

/// A colour of this opacity as seen on white paper.
inline uint8_t on_paper(int colour, int alpha) { return lay_over(colour, 255, alpha); }

/// Copies the whole of `picture` into `ground`, its left upper pixel to (left, top). Precondition:
/// it lies inside and has as many channels. O(pixels of the picture).
template <class T>
void paste(Image<T>& ground, int left, int top, const Image<T>& picture) {
  const size_t row = static_cast<size_t>(picture.width) * picture.channels;
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(&picture.at(0, y), row, &ground.at(left, top + y));
}

/// Whether the opaque pixels are light and few: lines meant for a dark ground. `rgba` has 4
/// channels. O(pixels).
bool is_light_on_nothing(const Image8& rgba);

/// Mean colour of every label of a drawing on white, 0 to 255 a channel, by label from 0 to the
/// largest. Pixels less than 3 px from another label, where outlines run, do not count; a label
/// that has no others is taken whole. `rgba` has the size of `labels`. O(pixels).
std::vector<std::array<double, 3>> label_colours(const Image8& rgba, const Image16& labels);

}  // namespace relievo
