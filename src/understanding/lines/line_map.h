#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "relievo/image.h"

namespace relievo::understanding {

/// The lines of a drawing and the edges between its colours, which separate its areas.
struct LineMap {
  enum Barrier : uint8_t {
    none = 0,
    line = 1,
    edge = 2,    ///< an edge between colours without a line; separates areas of different colour
    bridge = 3,  ///< a closed gap; separates areas like a line
    gap = 4,     ///< a gap in an outline, closed until it is known whether it bounds the figure
  };

  /// Returns whether a barrier separates areas whatever their colours.
  static bool is_wall(uint8_t barrier) {
    return barrier == line || barrier == bridge || barrier == gap;
  }

  Image8 ink;             ///< contrast of lines and edges with both sides, 255 = full
  Image8 barrier;         ///< [Barrier]
  double line_width = 1;  ///< typical width of a line, px
  bool painted = false;   ///< colours fill the areas; else lines bound white ones
};

/// Width of the widest line, per diagonal of the picture; wider dark shapes are areas.
constexpr double widest_line = 0.025;

/// Returns the least of a pixel's red, green and blue.
inline int darkest_channel(const Image8& rgb, int x, int y) {
  return std::min({rgb.at(x, y, 0), rgb.at(x, y, 1), rgb.at(x, y, 2)});
}

/// Returns the pixels that share a side with (x, y), which may lie outside the picture.
inline std::array<std::pair<int, int>, 4> side_neighbours(int x, int y) {
  return {{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
}

/// Darkest channel, of 255, below which a pixel on pure white is paint.
constexpr int palest_paint = 246;

/// Returns whether a pixel (3 channels) is ink or dark paint.
inline bool is_dark(const uint8_t* rgb) { return std::max({rgb[0], rgb[1], rgb[2]}) < 120; }

/// Finds the lines of a drawing on white (3 channels), which are darker than both of their sides
/// (black top-hat transform with hysteresis), and then the edges between areas of different colour
/// where no line runs. On pure white, pale colours count as paint. O(pixels).
LineMap find_lines(const Image8& rgb, bool on_pure_white = false);

}  // namespace relievo::understanding
