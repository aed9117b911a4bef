#include "kernel/geometry/polygon.h"

#include <algorithm>

namespace relievo {

void Box2::add(Point2 p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y)};
}

void Box2::add(const Box2& box) {
  if (box.empty()) return;
  add(box.min);
  add(box.max);
}

double signed_area(const Ring& ring) {
  double twice = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - ring[0];
    const Point2 b = ring[(i + 1) % ring.size()] - ring[0];
    twice += cross(a, b);
  }
  return 0.5 * twice;
}

double perimeter(const Ring& ring) {
  double length = 0;
  for (size_t i = 0; i < ring.size(); ++i) length += distance(ring[i], ring[(i + 1) % ring.size()]);
  return length;
}

Box2 bounding_box(const Ring& ring) {
  Box2 box;
  for (const Point2 p : ring) box.add(p);
  return box;
}

Box2 bounding_box(const Outline& outline) {
  Box2 box;
  for (const Ring& ring : outline) box.add(bounding_box(ring));
  return box;
}

int winding_number(const Ring& ring, Point2 p) {
  int winding = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i];
    const Point2 b = ring[(i + 1) % ring.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && side > 0) ++winding;
    if (a.y > p.y && side < 0) --winding;
  }
  return winding;
}

bool contains(const Outline& outline, Point2 p) {
  int winding = 0;
  for (const Ring& ring : outline) winding += winding_number(ring, p);
  return winding != 0;
}

void orient_by_nesting(Outline& outline) {
  std::vector<bool> reversed(outline.size());
  std::vector<Box2> boxes;
  for (const Ring& ring : outline) boxes.push_back(bounding_box(ring));
  const auto may_hold = [&boxes](size_t j, Point2 p) {
    return p.x >= boxes[j].min.x && p.x <= boxes[j].max.x && p.y >= boxes[j].min.y &&
           p.y <= boxes[j].max.y;
  };
  for (size_t i = 0; i < outline.size(); ++i) {
    int depth = 0;
    for (size_t j = 0; j < outline.size(); ++j)
      if (j != i && !outline[i].empty() && may_hold(j, outline[i][0]) &&
          winding_number(outline[j], outline[i][0]) != 0)
        ++depth;
    const double area = signed_area(outline[i]);
    reversed[i] = area != 0 && (area > 0) != (depth % 2 == 0);
  }
  for (size_t i = 0; i < outline.size(); ++i)
    if (reversed[i]) std::reverse(outline[i].begin() + 1, outline[i].end());
}

}  // namespace relievo
