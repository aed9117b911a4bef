#include "understanding/labels/stroke_pixels.h"

#include <algorithm>
#include <cmath>

namespace relievo::understanding {
namespace {

/// Calls visit(x, y) for the pixels of the image whose centres lie within `radius` of a segment.
template <class Visit>
void visit_near(Point2 a, Point2 b, double radius, int width, int height, const Visit& visit) {
  const auto first = [&](double v) {
    return std::max(0, static_cast<int>(std::floor(v - radius)));
  };
  const auto last = [&](double v, int n) {
    return std::min(n - 1, static_cast<int>(std::ceil(v + radius)));
  };
  const Point2 d = b - a;
  const double length2 = dot(d, d);
  for (int y = first(std::min(a.y, b.y)); y <= last(std::max(a.y, b.y), height); ++y)
    for (int x = first(std::min(a.x, b.x)); x <= last(std::max(a.x, b.x), width); ++x) {
      const Point2 p{x + 0.5, y + 0.5};
      const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0;
      if (distance(p, a + t * d) <= radius) visit(x, y);
    }
}

/// Calls visit(x, y) for the pixels that a stroke covers, some of them repeatedly. Long segments
/// are divided, so that their boxes contain few other pixels.
template <class Visit>
void visit_stroke(const Scribble& stroke, int width, int height, const Visit& visit) {
  const double radius = stroke.width / 2;
  for (size_t k = 0; k < stroke.points.size(); ++k) {
    const Point2 a = stroke.points[k];
    const Point2 b = stroke.points[std::min(k + 1, stroke.points.size() - 1)];
    const int pieces = 1 + static_cast<int>(distance(a, b) / (4 * radius + 8));
    for (int i = 0; i < pieces; ++i)
      visit_near(a + (1.0 * i / pieces) * (b - a), a + ((i + 1.0) / pieces) * (b - a), radius,
                 width, height, visit);
    const int x = static_cast<int>(std::floor(a.x));
    const int y = static_cast<int>(std::floor(a.y));
    if (x >= 0 && y >= 0 && x < width && y < height) visit(x, y);
  }
}

}  // namespace

std::vector<StrokePixel> stroke_pixels(const Scribbles& scribbles, int width, int height) {
  std::vector<StrokePixel> marks;
  for (size_t k = 0; k < scribbles.strokes.size(); ++k)
    visit_stroke(scribbles.strokes[k], width, height, [&](int x, int y) {
      marks.push_back({static_cast<int32_t>(int64_t{y} * width + x), static_cast<int>(k)});
    });
  std::sort(marks.begin(), marks.end(), [](const StrokePixel& a, const StrokePixel& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.stroke > b.stroke;
  });
  marks.erase(
      std::unique(marks.begin(), marks.end(),
                  [](const StrokePixel& a, const StrokePixel& b) { return a.pixel == b.pixel; }),
      marks.end());
  return marks;
}

}  // namespace relievo::understanding
