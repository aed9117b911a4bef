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

struct Step {
  int size = 0;
  bool along_x = false;
};

/// The strongest change of any channel at a pixel.
Step step_at(const Image8& rgb, int x, int y) {
  const uint8_t* left = &rgb.at(std::max(0, x - 1), y);
  const uint8_t* right = &rgb.at(std::min(rgb.width - 1, x + 1), y);
  const uint8_t* above = &rgb.at(x, std::max(0, y - 1));
  const uint8_t* below = &rgb.at(x, std::min(rgb.height - 1, y + 1));
  int dx = 0;
  int dy = 0;
  for (int c = 0; c < 3; ++c) {
    dx = std::max(dx, std::abs(right[c] - left[c]));
    dy = std::max(dy, std::abs(below[c] - above[c]));
  }
  return {std::min(255, std::max(dx, dy) + std::min(dx, dy) / 2), dx >= dy};
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
  Image8 size(rgb.width, rgb.height, 1);
  Image8 along_x(rgb.width, rgb.height, 1);
  for (int y = 0; y < rgb.height; ++y)
    for (int x = 0; x < rgb.width; ++x) {
      if (near_line.at(x, y) != 0) continue;
      const Step step = step_at(smooth, x, y);
      size.at(x, y) = static_cast<uint8_t>(step.size);
      along_x.at(x, y) = step.along_x ? 1 : 0;
    }
  const Image8 edges = connected_above(crests(size, along_x), possible_step, sure_step);
  for (size_t i = 0; i < edges.pixels.size(); ++i) {
    if (edges.pixels[i] == 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], size.pixels[i]);
  }
}

}  // namespace relievo
