#include "understanding/labels/mark_pixels.h"

#include <algorithm>
#include <cmath>

namespace relievo::understanding {
namespace {

class Marker {
 public:
  Marker(int width, int height, std::vector<MarkedPixel>& marks)
      : width_(width), height_(height), marks_(marks) {}

  void add(const Scribble& stroke, int number) {
    for (size_t k = 0; k < stroke.points.size(); ++k)
      add_segment(stroke.points[k], stroke.points[std::min(k + 1, stroke.points.size() - 1)],
                  stroke.width / 2, number);
  }

 private:
  /// Long segments are cut, so that the boxes looked through hold few pixels besides.
  void add_segment(Point2 a, Point2 b, double radius, int number) {
    const int pieces = 1 + static_cast<int>(distance(a, b) / (4 * radius + 8));
    for (int k = 0; k < pieces; ++k)
      add_piece(a + (1.0 * k / pieces) * (b - a), a + ((k + 1.0) / pieces) * (b - a), radius,
                number);
    mark(static_cast<int>(std::floor(a.x)), static_cast<int>(std::floor(a.y)), number);
  }

  void add_piece(Point2 a, Point2 b, double radius, int number) {
    const auto first = [&](double v) {
      return std::max(0, static_cast<int>(std::floor(v - radius)));
    };
    const auto last = [&](double v, int n) {
      return std::min(n - 1, static_cast<int>(std::ceil(v + radius)));
    };
    const Point2 d = b - a;
    const double length2 = dot(d, d);
    for (int y = first(std::min(a.y, b.y)); y <= last(std::max(a.y, b.y), height_); ++y)
      for (int x = first(std::min(a.x, b.x)); x <= last(std::max(a.x, b.x), width_); ++x) {
        const Point2 p{x + 0.5, y + 0.5};
        const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0;
        if (distance(p, a + t * d) <= radius) mark(x, y, number);
      }
  }

  void mark(int x, int y, int number) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    marks_.push_back({static_cast<int32_t>(int64_t{y} * width_ + x), number});
  }

  int width_;
  int height_;
  std::vector<MarkedPixel>& marks_;
};

}  // namespace

std::vector<MarkedPixel> mark_pixels(const Scribbles& scribbles, int width, int height) {
  std::vector<MarkedPixel> marks;
  Marker marker(width, height, marks);
  for (size_t k = 0; k < scribbles.strokes.size(); ++k)
    marker.add(scribbles.strokes[k], static_cast<int>(k));
  std::sort(marks.begin(), marks.end(), [](const MarkedPixel& a, const MarkedPixel& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.stroke > b.stroke;
  });
  marks.erase(
      std::unique(marks.begin(), marks.end(),
                  [](const MarkedPixel& a, const MarkedPixel& b) { return a.pixel == b.pixel; }),
      marks.end());
  return marks;
}

}  // namespace relievo::understanding
