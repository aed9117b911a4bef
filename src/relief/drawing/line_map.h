#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "relief/drawing/segmentation.h"
#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo {

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

/// Adds to map.barrier the edges between colours that no line marks, and to map.ink how strong
/// they are. `rgb` is the drawing on white; map.barrier holds its lines. O(pixels).
void add_colour_edges(const Image8& rgb, LineMap& map);

/// 1 where `values` (one channel) reach `low` and hang together, over sides and corners, with a
/// pixel that reaches `high`; 0 elsewhere. O(pixels).
Image8 connected_above(const Image8& values, int low, int high);

/// The pieces of the boundaries between labels along which neither side lies on a line or edge
/// (`barrier` 0), as polylines within 1 px. Those shorter than the lines are wide are noise and
/// left out. O(pixels).
std::vector<Bridge> find_bridges(const Image16& labels, const Image8& barrier, double line_width);

/// A loose end of a stroke. Where the stroke, followed from there, first passes the end of another
/// line, the side on which that line ends lies behind it.
struct StrokeEnd {
  Point2 at;          ///< px
  Point2 inwards;     ///< unit vector from the end along the stroke
  double length = 0;  ///< px along the stroke to its other end or the first other line
  int behind = 0;     ///< the side that lies behind: 1 on the right of `inwards`, -1 on the left
};

/// Finds them in thinned lines (0 off the lines), in raster order. Strokes are followed for up to
/// `longest` px. O(pixels + ends * longest).
std::vector<StrokeEnd> find_stroke_ends(const Image8& thinned, double line_width, double longest);

}  // namespace relievo
