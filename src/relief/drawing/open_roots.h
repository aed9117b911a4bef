#pragma once

#include <vector>

#include "relief/drawing/line_map.h"
#include "relievo/point.h"

namespace relievo {

/// The loose ends of the two lines that are the sides of a limb, where it grows out of what lies
/// behind it.
struct OpenRoot {
  Point2 a;  ///< px
  Point2 b;
};

/// Finds pairs of loose ends side by side, narrowest first, each end in one pair at most. Both
/// strokes run the same way for longer than the gap between them is wide, and the first other
/// lines that they come across end at their outer sides, as outlines do that a limb hides; hatching
/// and whiskers do not hide what they cross. No line or edge runs between the ends. O(pixels).
std::vector<OpenRoot> find_open_roots(const LineMap& map);

/// Marks the way from one end to the other as a bridge where there is no line or edge.
void close_root(const OpenRoot& root, Image8& barrier);

}  // namespace relievo
