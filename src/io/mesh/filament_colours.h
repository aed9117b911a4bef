#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// A few colours, and the one of each triangle of a model.
struct FilamentColours {
  std::vector<std::array<uint8_t, 3>> colours;  ///< sRGB, by the area they paint, largest first
  std::vector<uint8_t> triangle;                ///< #F index in `colours`
};

/// Chooses at most `count` colours (at least 1) by k-means over the area of the surface in OKLab.
/// The first centres are the most frequent colour and those farthest from all others. A triangle
/// has the colour of its middle. `texture`: RGB. O(F + colours * count).
FilamentColours reduce_colours(const Model& model, const Image8& texture, int count);

}  // namespace relievo
