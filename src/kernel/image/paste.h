#pragma once

#include <algorithm>

#include "relievo/image.h"

namespace relievo {

/// Copies the whole of `picture` into `ground`, its left upper pixel to (left, top). Precondition:
/// it lies inside and has as many channels. O(pixels of the picture).
template <class T>
void paste(Image<T>& ground, int left, int top, const Image<T>& picture) {
  const size_t row = static_cast<size_t>(picture.width) * picture.channels;
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(&picture.at(0, y), row, &ground.at(left, top + y));
}

}  // namespace relievo
