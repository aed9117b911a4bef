#include "kernel/image/fill_outline.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace relievo {
namespace {

/// Where a ring crosses the line through the centres of a row of pixels.
struct RowCrossing {
  double x = 0;
  int direction = 0;
};

/// First pixel whose centre is at or after coordinate v, kept within [0, size].
int first_centre(double v, int size) {
  return static_cast<int>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(size)));
}

void add_crossings(Point2 a, Point2 b, int top, std::vector<std::vector<RowCrossing>>& rows) {
  if (a.y == b.y) return;
  const int direction = a.y < b.y ? 1 : -1;
  if (direction < 0) std::swap(a, b);
  const int count = static_cast<int>(rows.size());
  const int first = first_centre(a.y - top, count);
  const int last = first_centre(b.y - top, count);
  for (int y = first; y < last; ++y) {
    const double t = (y + top + 0.5 - a.y) / (b.y - a.y);
    rows[y].push_back({a.x + t * (b.x - a.x), direction});
  }
}

void fill_row(std::vector<RowCrossing>& row, Mask& mask, int y) {
  std::sort(row.begin(), row.end(), [](const RowCrossing& p, const RowCrossing& q) {
    return p.x < q.x || (p.x == q.x && p.direction < q.direction);
  });
  int winding = 0;
  for (size_t i = 0; i + 1 < row.size(); ++i) {
    winding += row[i].direction;
    if (winding == 0) continue;
    const int first = first_centre(row[i].x - mask.left, mask.inside.width);
    const int last = first_centre(row[i + 1].x - mask.left, mask.inside.width);
    for (int x = first; x < last; ++x) mask.inside.at(x, y) = 1;
  }
}

}  // namespace

Mask fill_outline(const Outline& outline, int width, int height) {
  const Box2 box = bounding_box(outline);
  if (box.empty()) return {};
  const int left = first_centre(box.min.x, width);
  const int top = first_centre(box.min.y, height);
  const int right = first_centre(box.max.x, width);
  const int bottom = first_centre(box.max.y, height);
  if (right <= left || bottom <= top) return {};
  Mask mask = empty_mask(left, top, right, bottom);
  std::vector<std::vector<RowCrossing>> rows(mask.inside.height);
  for (const Ring& ring : outline)
    for (size_t i = 0; i < ring.size(); ++i)
      add_crossings(ring[i], ring[(i + 1) % ring.size()], mask.top, rows);
  for (int y = 0; y < mask.inside.height; ++y) fill_row(rows[y], mask, y);
  return mask;
}

}  // namespace relievo
