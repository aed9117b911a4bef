#include "understanding/paper/page.h"

#include <algorithm>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/mask.h"

namespace relievo::understanding {
namespace {

constexpr double along_share = 0.67;  ///< least share of an edge that an area along it covers
constexpr double strip_share = 0.15;  ///< area of a strip at most, as a share of the picture

/// Returns the first and last pixel of a mask in each row. One pixel of a row that is farthest from
/// any point or line is among them.
std::vector<Point2> ends_of_rows(const Image8& mask) {
  std::vector<Point2> ends;
  for (int y = 0; y < mask.height; ++y) {
    int first = 0;
    int last = mask.width - 1;
    while (first <= last && mask.at(first, y) == 0) ++first;
    while (last >= first && mask.at(last, y) == 0) --last;
    if (first > last) continue;
    ends.push_back({first + 0.5, y + 0.5});
    ends.push_back({last + 0.5, y + 0.5});
  }
  return ends;
}

/// Finds the four corners of a page: two opposite ones, which are farthest from the centre and from
/// each other, and the pixels farthest from their diagonal on either side.
std::array<Point2, 4> corners_of(const Image8& mask) {
  Point2 sum;
  double count = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0) {
        sum.x += x + 0.5;
        sum.y += y + 0.5;
        ++count;
      }
  const Point2 centre{sum.x / count, sum.y / count};
  const std::vector<Point2> ends = ends_of_rows(mask);
  const auto farthest = [&](auto measure) {
    return *std::max_element(ends.begin(), ends.end(),
                             [&](Point2 p, Point2 q) { return measure(p) < measure(q); });
  };
  const Point2 a = farthest([&](Point2 p) { return distance(p, centre); });
  const Point2 b = farthest([&](Point2 p) { return distance(p, a); });
  const auto side = [&](Point2 p) { return cross(b - a, p - a); };
  return {a, farthest(side), b, farthest([&](Point2 p) { return -side(p); })};
}

}  // namespace

double page_overlap(const Image8& mask) {
  if (pixel_count(mask) == 0) return 0;
  const std::array<Point2, 4> corners = corners_of(mask);
  const auto is_between = [&](Point2 p) {
    for (size_t k = 0; k < 4; ++k)
      if (cross(corners[(k + 1) % 4] - corners[k], p - corners[k]) > 0) return false;
    return true;
  };
  double both = 0;
  double either = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const bool between = is_between({x + 0.5, y + 0.5});
      both += between && mask.at(x, y) != 0 ? 1 : 0;
      either += between || mask.at(x, y) != 0 ? 1 : 0;
    }
  return both / either;
}

bool is_around_page(const std::array<int64_t, 4>& at_edge, int64_t area, int width, int height) {
  const std::array<int, 4> sides = {height, height, width, width};
  int along = 0;
  for (size_t e = 0; e < sides.size(); ++e)
    along += static_cast<double>(at_edge[e]) > along_share * sides[e] ? 1 : 0;
  return along > 1 || (along == 1 && static_cast<double>(area) <
                                         strip_share * static_cast<double>(width) * height);
}

}  // namespace relievo::understanding
