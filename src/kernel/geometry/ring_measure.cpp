#include "kernel/geometry/ring_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievo {
namespace {

double clamped_parameter(Point2 p, Point2 a, Point2 b) {
  const Point2 d = b - a;
  const double squared = dot(d, d);
  return squared > 0 ? std::clamp(dot(p - a, d) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

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
