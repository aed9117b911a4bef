#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "relievo/image.h"

namespace relievo::understanding {

/// What separates the areas of a drawing.
struct LineMap {
  enum Barrier : uint8_t { none = 0, line = 1, edge = 2, bridge = 3, gap = 4 };

  /// Whether it parts areas whatever their colours.
  static bool is_wall(uint8_t barrier) {
    return barrier == line || barrier == bridge || barrier == gap;
  }

  Image8 ink;      ///< how much darker a pixel is than what lies around it, 255 = full
  Image8 barrier;  ///< [Barrier] lines, edges between colours where there is no line, closed gaps
  double line_width = 1;  ///< typical width of a line, px
  bool painted = false;   ///< whether colours fill areas, rather than lines bounding white ones
};

/// Lines are narrower than this share of the diagonal; wider dark shapes are areas.
constexpr double widest_line = 0.025;

/// The least of a pixel's red, green and blue.
inline int darkest_channel(const Image8& rgb, int x, int y) {
  return std::min({rgb.at(x, y, 0), rgb.at(x, y, 1), rgb.at(x, y, 2)});
}

/// The pixels that share a side with (x, y).
inline std::array<std::pair<int, int>, 4> sides_of(int x, int y) {
  return {{{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}};
}

/// Paint on pure white is darker than this in one channel at least.
constexpr int palest = 246;

/// Whether a pixel (3 channels) is ink or dark paint.
inline bool is_dark(const uint8_t* rgb) { return std::max({rgb[0], rgb[1], rgb[2]}) < 120; }

/// Finds the lines of a drawing on white (3 channels): darker than both sides, whatever the
/// colours there (black top-hat with hysteresis), and then the edges between areas of different
/// colour where no line runs (Canny's ridges of the gradient). On pure white pale colours are paint
/// as well. O(pixels).
LineMap find_lines(const Image8& rgb, bool on_pure_white = false);

/// 1 where `values` (one channel) reach `low` and hang together, over sides and corners, with a
/// pixel that reaches `high`; 0 elsewhere. O(pixels).
Image8 connected_above(const Image8& values, int low, int high);

}  // namespace relievo::understanding
