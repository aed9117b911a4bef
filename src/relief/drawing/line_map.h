#pragma once

#include "relievo/image.h"

namespace relievo {

/// What separates the areas of a drawing.
struct LineMap {
  enum Barrier : uint8_t { none = 0, line = 1, edge = 2, bridge = 3 };

  /// Whether it parts areas whatever their colours.
  static bool is_wall(uint8_t barrier) { return barrier == line || barrier == bridge; }

  Image8 ink;      ///< how much darker a pixel is than what lies around it, 255 = full
  Image8 barrier;  ///< [Barrier] lines, edges between colours where there is no line, closed roots
  double line_width = 1;  ///< typical width of a line, px
  bool painted = false;   ///< whether colours fill areas, rather than lines bounding white ones
};

/// Lines are narrower than this share of the diagonal; wider dark shapes are areas.
constexpr double widest_line = 0.025;

/// Finds the lines of a drawing on white (3 channels): darker than both sides, whatever the
/// colours there (black top-hat with hysteresis), and then the edges between areas of different
/// colour where no line runs (Canny's ridges of the gradient). O(pixels).
LineMap find_lines(const Image8& rgb);

}  // namespace relievo
