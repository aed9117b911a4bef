#include "relief/drawing/open_roots.h"

#include <algorithm>
#include <cmath>

#include "kernel/image/morphology.h"
#include "relief/drawing/line_map.h"

namespace relievo {
namespace {

constexpr double longest_side = 0.25;    ///< of a limb at its root, per diagonal of the picture
constexpr double length_per_gap = 0.75;  ///< that both sides have at least
constexpr double same_way = 0.7;         ///< cosine of the angle between the sides, at least
constexpr double across = 0.75;          ///< cosine of the angle of gap and sides, at most
constexpr double narrowest_gap = 3;      ///< widths of a line

/// Calls visit(x, y) for the pixels from a to b, each of which shares a side with the next.
template <class Visit>
void for_pixels_between(Point2 a, Point2 b, const Visit& visit) {
  const int steps = 2 * static_cast<int>(std::ceil(distance(a, b)));
  int last_x = static_cast<int>(a.x);
  for (int k = 0; k <= steps; ++k) {
    const Point2 p = a + (static_cast<double>(k) / steps) * (b - a);
    const int x = static_cast<int>(p.x);
    const int y = static_cast<int>(p.y);
    if (x != last_x) visit(last_x, y);
    visit(x, y);
    last_x = x;
  }
}

/// 1 for cells of `side` px that hold a pixel of a line.
Image8 line_cells(const Image8& barrier, int side) {
  Image8 cells((barrier.width + side - 1) / side, (barrier.height + side - 1) / side, 1);
  for (int y = 0; y < barrier.height; ++y) {
    const uint8_t* row = &barrier.at(0, y);
    uint8_t* out = &cells.at(0, y / side);
    for (int x = 0; x < barrier.width; ++x)
      if (row[x] == LineMap::line) out[x / side] = 1;
  }
  return cells;
}

/// Found in cells of a third of the lines' width, since wide lines are slow to thin.
std::vector<StrokeEnd> loose_ends(const LineMap& map) {
  const int side = std::max(1, static_cast<int>(map.line_width / 3));
  const Image8 cells = line_cells(map.barrier, side);
  const double longest = longest_side * std::hypot(cells.width, cells.height);
  std::vector<StrokeEnd> ends = find_stroke_ends(thin(cells), map.line_width / side, longest);
  for (StrokeEnd& end : ends) {
    end.at = static_cast<double>(side) * end.at;
    end.length *= side;
  }
  return ends;
}

/// Whether lines end on the other side of the stroke than `point` lies.
bool hides_outer_side(const StrokeEnd& end, Point2 point) {
  return cross(end.inwards, point - end.at) * end.behind < 0;
}

bool are_sides_of_limb(const StrokeEnd& a, const StrokeEnd& b, double line_width) {
  const double gap = distance(a.at, b.at);
  if (gap < narrowest_gap * line_width) return false;
  if (std::min(a.length, b.length) < length_per_gap * gap) return false;
  if (dot(a.inwards, b.inwards) < same_way) return false;
  const Point2 middle = a.inwards + b.inwards;
  if (std::abs(dot(middle, b.at - a.at)) > across * gap * norm(middle)) return false;
  return hides_outer_side(a, b.at) && hides_outer_side(b, a.at);
}

/// Whether no line or edge lies between the ends, whose own lines reach a little farther.
bool is_clear(const Image8& barrier, const OpenRoot& root, double line_width) {
  bool clear = true;
  for_pixels_between(root.a, root.b, [&](int x, int y) {
    const Point2 p{x + 0.5, y + 0.5};
    if (std::min(distance(p, root.a), distance(p, root.b)) > line_width + 1)
      clear = clear && barrier.at(x, y) == LineMap::none;
  });
  return clear;
}

}  // namespace

std::vector<OpenRoot> find_open_roots(const LineMap& map) {
  const std::vector<StrokeEnd> ends = loose_ends(map);
  std::vector<OpenRoot> roots;
  for (size_t i = 0; i < ends.size(); ++i)
    for (size_t j = i + 1; j < ends.size(); ++j)
      if (are_sides_of_limb(ends[i], ends[j], map.line_width))
        roots.push_back({ends[i].at, ends[j].at});
  std::stable_sort(roots.begin(), roots.end(), [](const OpenRoot& x, const OpenRoot& y) {
    return distance(x.a, x.b) < distance(y.a, y.b);
  });
  std::vector<OpenRoot> chosen;
  for (const OpenRoot& root : roots) {
    const auto shares_end = [&](const OpenRoot& other) {
      return root.a == other.a || root.a == other.b || root.b == other.a || root.b == other.b;
    };
    if (std::none_of(chosen.begin(), chosen.end(), shares_end) &&
        is_clear(map.barrier, root, map.line_width))
      chosen.push_back(root);
  }
  return chosen;
}

void close_root(const OpenRoot& root, Image8& barrier) {
  for_pixels_between(root.a, root.b, [&](int x, int y) {
    uint8_t& value = barrier.at(x, y);
    if (value == LineMap::none) value = LineMap::bridge;
  });
}

}  // namespace relievo
