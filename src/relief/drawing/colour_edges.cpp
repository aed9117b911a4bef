#include "relief/drawing/colour_edges.h"

#include <algorithm>
#include <cstdlib>

#include "kernel/image/blur.h"
#include "kernel/image/morphology.h"
#include "relief/drawing/hysteresis.h"

namespace relievo {
namespace {

constexpr int sure_step = 44;      ///< change of a channel over two pixels that is an edge
constexpr int possible_step = 22;  ///< where it continues one
constexpr int line_margin = 4;     ///< px around lines, whose own flanks are no edges

/// The strongest change of any channel at every pixel of the inside, and whether it is along x.
struct Steps {
  Image8 size;
  Image8 along_x;
};

int largest_difference(const uint8_t* a, const uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Steps where `excluded` is 0.
Steps measure_steps(const Image8& rgb, const Image8& excluded) {
  Steps steps{Image8(rgb.width, rgb.height, 1), Image8(rgb.width, rgb.height, 1)};
  const ptrdiff_t row = ptrdiff_t{3} * rgb.width;
  for (int y = 1; y + 1 < rgb.height; ++y) {
    const size_t begin = static_cast<size_t>(y) * rgb.width;
    for (size_t i = begin + 1; i + 1 < begin + rgb.width; ++i) {
      if (excluded.pixels[i] != 0) continue;
      const uint8_t* p = &rgb.pixels[3 * i];
      const int dx = largest_difference(p + 3, p - 3);
      const int dy = largest_difference(p + row, p - row);
      const int size = std::max(dx, dy) + std::min(dx, dy) / 2;
      steps.size.pixels[i] = static_cast<uint8_t>(std::min(255, size));
      steps.along_x.pixels[i] = dx >= dy ? 1 : 0;
    }
  }
  return steps;
}

/// Steps that are the largest across their edge; 0 elsewhere.
Image8 crests(const Image8& size, const Image8& along_x) {
  Image8 result(size.width, size.height, 1);
  for (int y = 1; y + 1 < size.height; ++y)
    for (int x = 1; x + 1 < size.width; ++x) {
      const uint8_t value = size.at(x, y);
      if (value < possible_step) continue;
      const bool across_x = along_x.at(x, y) != 0;
      const uint8_t before = across_x ? size.at(x - 1, y) : size.at(x, y - 1);
      const uint8_t after = across_x ? size.at(x + 1, y) : size.at(x, y + 1);
      if (value > before && value >= after) result.at(x, y) = value;
    }
  return result;
}

}  // namespace

void add_colour_edges(const Image8& rgb, LineMap& map) {
  const Image8 smooth = box_blur(rgb, map.painted ? 2 : 1);
  const Image8 near_line = max_filter(map.barrier, line_margin);
  const Steps steps = measure_steps(smooth, near_line);
  const Image8 edges = connected_above(crests(steps.size, steps.along_x), possible_step, sure_step);
  for (size_t i = 0; i < edges.pixels.size(); ++i) {
    if (edges.pixels[i] == 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], steps.size.pixels[i]);
  }
}

}  // namespace relievo
