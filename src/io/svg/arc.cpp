#include <algorithm>
#include <cmath>

#include "io/svg/path_data.h"

namespace relievo {
namespace {

constexpr double pi = 3.14159265358979323846;

/// An ellipse by its centre and the map from the unit circle.
struct EllipseArc {
  Affine2 from_unit;
  double begin = 0;  ///< radians on the unit circle
  double span = 0;   ///< signed
};

/// Endpoint to centre parametrisation [SVG 1.1, F.6.5 and F.6.6].
EllipseArc centre_form(Point2 from, const ArcShape& shape, Point2 to) {
  const double phi = shape.rotation * pi / 180;
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  double rx = std::abs(shape.rx);
  double ry = std::abs(shape.ry);
  const Point2 half = 0.5 * (from - to);
  Point2 q{(c * half.x + s * half.y) / rx, (-s * half.x + c * half.y) / ry};
  const double grow = std::max(1.0, norm(q));
  rx *= grow;
  ry *= grow;
  q = (1 / grow) * q;

  // On the unit circle the chord runs from q to -q around the centre m, perpendicular to it.
  const double length2 = dot(q, q);
  const double reach = std::sqrt(std::max(0.0, 1 / length2 - 1));
  const double side = shape.large == shape.sweep ? -reach : reach;
  const Point2 m{side * q.y, -side * q.x};
  const Point2 begin = q - m;
  const Point2 end = Point2{-q.x, -q.y} - m;

  EllipseArc arc;
  arc.begin = std::atan2(begin.y, begin.x);
  arc.span = std::atan2(cross(begin, end), dot(begin, end));
  if (shape.sweep && arc.span < 0) arc.span += 2 * pi;
  if (!shape.sweep && arc.span > 0) arc.span -= 2 * pi;
  const Affine2 axes{c * rx, s * rx, -s * ry, c * ry, 0, 0};
  const Point2 middle = 0.5 * (from + to) + axes(m);
  arc.from_unit = translation(middle.x, middle.y) * axes;
  return arc;
}

}  // namespace

void append_arc(PathData& path, Point2 from, const ArcShape& shape, Point2 to) {
  if (from == to) return;
  if (shape.rx == 0 || shape.ry == 0) {
    path.push_back({SegmentKind::line, {}, {}, to});
    return;
  }
  const EllipseArc arc = centre_form(from, shape, to);
  if (!std::isfinite(arc.span)) {
    path.push_back({SegmentKind::line, {}, {}, to});
    return;
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(arc.span) / (pi / 4))));
  const double step = arc.span / pieces;
  const double handle = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const double a = arc.begin + i * step;
    const double b = a + step;
    const Point2 c1{std::cos(a) - handle * std::sin(a), std::sin(a) + handle * std::cos(a)};
    const Point2 c2{std::cos(b) + handle * std::sin(b), std::sin(b) - handle * std::cos(b)};
    const Point2 end = i + 1 == pieces ? to : arc.from_unit({std::cos(b), std::sin(b)});
    path.push_back({SegmentKind::cubic, arc.from_unit(c1), arc.from_unit(c2), end});
  }
}

}  // namespace relievo
