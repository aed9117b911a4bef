#include "kernel/image/level_contours.h"

#include <cassert>
#include <tuple>
#include <utility>

namespace relievo {
namespace {

/// A crossing of a contour with the segment from sample (x, y) to its right neighbour (`upright`
/// false) or to the one below (true).
struct LevelCrossing {
  int x = 0;
  int y = 0;
  bool upright = false;
};

/// Follows contours from cell to cell. Cell (x, y) has the samples (x, y) to (x + 1, y + 1).
/// Samples and cells beside the image have the index -1.
class LevelTracer {
 public:
  LevelTracer(const ImageF& field, float level, float outside)
      : field_(field),
        level_(level),
        outside_(outside),
        seen_(static_cast<size_t>(field.width + 1) * field.height, 0) {}

  Outline run() {
    Outline rings;
    for (int y = 0; y < field_.height; ++y)
      for (int x = -1; x < field_.width; ++x)
        if (is_inside(x, y) != is_inside(x + 1, y) && !seen(x, y)) rings.push_back(trace(x, y));
    return rings;
  }

 private:
  float sample(int x, int y) const {
    const bool within = x >= 0 && y >= 0 && x < field_.width && y < field_.height;
    return within ? field_.at(x, y) : outside_;
  }

  bool is_inside(int x, int y) const { return sample(x, y) >= level_; }

  char& seen(int x, int y) { return seen_[static_cast<size_t>(y) * (field_.width + 1) + x + 1]; }

  Point2 position(const LevelCrossing& at) const {
    const double a = sample(at.x, at.y);
    const double b = at.upright ? sample(at.x, at.y + 1) : sample(at.x + 1, at.y);
    const double t = (level_ - a) / (b - a);
    return {at.x + 0.5 + (at.upright ? 0 : t), at.y + 0.5 + (at.upright ? t : 0)};
  }

  /// Follows the contour through the crossing between (x, y) and its right neighbour, with the
  /// inside on the right hand as seen on the screen, y down. It leaves the crossing downwards where
  /// the inside is to the left of it, upwards otherwise.
  Ring trace(int x, int y) {
    Ring ring;
    const LevelCrossing start{x, y, false};
    LevelCrossing at = start;
    bool forward = is_inside(x, y);  // down, or to the left of an upright crossing
    do {
      if (!at.upright) seen(at.x, at.y) = 1;
      ring.push_back(position(at));
      std::tie(at, forward) = next(at, forward);
    } while (at.x != start.x || at.y != start.y || at.upright != start.upright);
    return ring;
  }

  /// Returns the other end of the contour's piece in the cell that it enters, and its direction
  /// there.
  std::pair<LevelCrossing, bool> next(const LevelCrossing& at, bool forward) const {
    if (!at.upright) return forward ? across(at.x, at.y, 0) : across(at.x, at.y - 1, 2);
    return forward ? across(at.x - 1, at.y, 1) : across(at.x, at.y, 3);
  }

  /// Returns the same for the cell (x, y), entered through `side`: 0 top, 1 right, 2 bottom, 3
  /// left. Corner k begins side k clockwise.
  std::pair<LevelCrossing, bool> across(int x, int y, int side) const {
    const bool corner[4] = {is_inside(x, y), is_inside(x + 1, y), is_inside(x + 1, y + 1),
                            is_inside(x, y + 1)};
    const auto crossed = [&](int k) { return corner[k & 3] != corner[(k + 1) & 3]; };
    const int before = side + 3;
    const int after = side + 1;
    int exit = crossed(side + 2) ? side + 2 : crossed(before) ? before : after;
    if (crossed(before) && crossed(after)) exit = turn(x, y, corner[side]) ? before : after;
    return leave(x, y, exit & 3);
  }

  /// Returns whether a contour that enters a side of a cell with two diagonal corners inside turns
  /// around the corner that begins the side: it does if that corner and the centre of the cell are
  /// on different sides of the level.
  bool turn(int x, int y, bool corner_inside) const {
    const float centre = 0.25F * (sample(x, y) + sample(x + 1, y)) +
                         0.25F * (sample(x, y + 1) + sample(x + 1, y + 1));
    return corner_inside != (centre >= level_);
  }

  static std::pair<LevelCrossing, bool> leave(int x, int y, int side) {
    const bool upright = side == 1 || side == 3;
    return {{side == 1 ? x + 1 : x, side == 2 ? y + 1 : y, upright}, side >= 2};
  }

  const ImageF& field_;
  float level_;
  float outside_;
  std::vector<char> seen_;  ///< crossings from (x, y) to (x + 1, y), x from -1
};

}  // namespace

Outline level_contours(const ImageF& field, float level, float outside) {
  assert(field.channels == 1 && outside < level);
  return LevelTracer(field, level, outside).run();
}

}  // namespace relievo
