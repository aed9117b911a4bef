#include "kernel/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relievo {
namespace {

double clamped_parameter(Point2 p, Point2 a, Point2 b) {
  const Point2 d = b - a;
  const double squared = dot(d, d);
  return squared > 0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

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

double area(const Outline& outline) {
  double sum = 0;
  for (const Ring& ring : outline) sum += signed_area(ring);
  return sum;
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

Ring convex_hull(std::vector<Point2> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(),
            [](Point2 a, Point2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  Ring hull;
  const auto add_chain = [&hull](auto first, auto last) {
    const size_t start = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
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

RingMeasure measure(const Ring& ring) {
  RingMeasure m;
  m.start.reserve(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    m.start.push_back(m.length);
    m.length += distance(ring[i], ring[(i + 1) % ring.size()]);
  }
  return m;
}

Point2 point_at(const Ring& ring, const RingMeasure& m, double s) {
  s -= std::floor(s / m.length) * m.length;
  const auto after = std::upper_bound(m.start.begin(), m.start.end(), s);
  const size_t i = static_cast<size_t>(std::max<std::ptrdiff_t>(after - m.start.begin() - 1, 0));
  const Point2 a = ring[i];
  const Point2 b = ring[(i + 1) % ring.size()];
  const double length = distance(a, b);
  return length > 0 ? a + ((s - m.start[i]) / length) * (b - a) : a;
}

RingFoot nearest_on_ring(const Ring& ring, const RingMeasure& m, Point2 p) {
  RingFoot best{0, std::numeric_limits<double>::infinity()};
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i];
    const Point2 b = ring[(i + 1) % ring.size()];
    const double t = clamped_parameter(p, a, b);
    const double gap = distance(p, a + t * (b - a));
    if (gap < best.distance) best = {m.start[i] + t * distance(a, b), gap};
  }
  return best;
}

double distance_to_polyline(const std::vector<Point2>& line, Point2 p) {
  double best = line.empty() ? std::numeric_limits<double>::infinity() : distance(line[0], p);
  for (size_t i = 0; i + 1 < line.size(); ++i)
    best = std::min(best, distance_to_segment(p, line[i], line[i + 1]));
  return best;
}

double distance_to_segment(Point2 p, Point2 a, Point2 b) {
  return distance(p, a + clamped_parameter(p, a, b) * (b - a));
}

}  // namespace relievo
