#pragma once

#include <algorithm>
#include <cmath>

namespace relievo {

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// The pixels, at least one a side, of a picture of the shape width x height whose longest side
/// has `longest` of them.
inline ImageSize fitted_size(double width, double height, double longest) {
  const auto pixels = [&](double side) {
    return std::max(1, static_cast<int>(std::lround(longest * side / std::max(width, height))));
  };
  return {pixels(width), pixels(height)};
}

}  // namespace relievo
