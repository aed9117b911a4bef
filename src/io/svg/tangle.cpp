#include "io/svg/tangle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/geometry/polygon.h"

namespace relievo {
namespace {

constexpr int cells = 64;

/// Counts the segments in each cell of a grid over a box.
class CellCounter {
 public:
  explicit CellCounter(const Box2& box)
      : origin_(box.min),
        scale_x_(cells / std::max(1e-9, box.max.x - box.min.x)),
        scale_y_(cells / std::max(1e-9, box.max.y - box.min.y)) {}

  /// Walks the cells row by row; in each row the segment covers a run of columns.
  void add(Point2 a, Point2 b) {
    if (a.y > b.y) std::swap(a, b);
    const int first = row(a.y);
    const int last = row(b.y);
    for (int y = first; y <= last; ++y) {
      const double x0 = y == first ? a.x : at_row_edge(a, b, y);
      const double x1 = y == last ? b.x : at_row_edge(a, b, y + 1);
      const int from = column(std::min(x0, x1));
      const int to = column(std::max(x0, x1));
      for (int x = from; x <= to; ++x) ++counts_[y * cells + x];
    }
  }

  double pairs() const {
    double sum = 0;
    for (const double count : counts_) sum += count * count;
    return sum;
  }

 private:
  static int cell(double value) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, cells - 1.0));
  }
  int column(double x) const { return cell((x - origin_.x) * scale_x_); }
  int row(double y) const { return cell((y - origin_.y) * scale_y_); }

  double at_row_edge(Point2 a, Point2 b, int row) const {
    const double y = origin_.y + row / scale_y_;
    const double t = std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
    return a.x + t * (b.x - a.x);
  }

  Point2 origin_;
  double scale_x_;
  double scale_y_;
  std::array<double, cells* cells> counts_ = {};
};

}  // namespace

double tangle(const std::vector<Polyline>& lines) {
  Box2 box;
  for (const Polyline& line : lines) box.add(bounding_box(line.points));
  if (box.empty()) return 0;
  CellCounter counter(box);
  for (const Polyline& line : lines) {
    for (size_t i = 0; i < line.points.size(); ++i) {
      counter.add(line.points[i], line.points[(i + 1) % line.points.size()]);
    }
  }
  return counter.pairs();
}

}  // namespace relievo
