#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// A uniform grid over a box that lists the items in each cell, as two flat arrays.
class SegmentGrid {
 public:
  /// Makes square cells, about one per item and at most 4 * items + 16.
  SegmentGrid(const Box2& box, size_t items) : origin_(box.min) {
    const double w = std::max(box.max.x - box.min.x, 1e-300);
    const double h = std::max(box.max.y - box.min.y, 1e-300);
    const double longest = std::max(w, h);
    const double n = static_cast<double>(items) + 4;
    cell_ = std::max(std::sqrt(w * h / n), longest / n);
    columns_ = static_cast<int>(w / cell_) + 1;
    rows_ = static_cast<int>(h / cell_) + 1;
    begin_.assign(static_cast<size_t>(columns_) * rows_ + 1, 0);
  }

  /// Calls visit(cell) for each cell within `margin` of the bounding box of segment ab.
  template <class Visit>
  void for_cells(Point2 a, Point2 b, double margin, Visit visit) const {
    const int x0 = column(std::min(a.x, b.x) - margin);
    const int x1 = column(std::max(a.x, b.x) + margin);
    const int y0 = row(std::min(a.y, b.y) - margin);
    const int y1 = row(std::max(a.y, b.y) + margin);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) visit(static_cast<size_t>(y) * columns_ + x);
  }

  /// Builds the lists of `items` items; ends(i) returns two opposite corners of the box of item i.
  /// O(items + entries).
  template <class Ends>
  void build(size_t items, Ends ends) {
    for (size_t i = 0; i < items; ++i)
      for_cells(ends(i).first, ends(i).second, 0, [&](size_t cell) { ++begin_[cell + 1]; });
    for (size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    entries_.resize(begin_.back());
    std::vector<size_t> next(begin_.begin(), begin_.end() - 1);
    for (size_t i = 0; i < items; ++i)
      for_cells(ends(i).first, ends(i).second, 0,
                [&](size_t cell) { entries_[next[cell]++] = static_cast<int>(i); });
  }

  /// The items of a cell are [begin(cell), end(cell)), ascending.
  const int* begin(size_t cell) const { return entries_.data() + begin_[cell]; }
  const int* end(size_t cell) const { return entries_.data() + begin_[cell + 1]; }

 private:
  int column(double x) const {
    return std::clamp(static_cast<int>((x - origin_.x) / cell_), 0, columns_ - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>((y - origin_.y) / cell_), 0, rows_ - 1);
  }

  Point2 origin_;
  double cell_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<size_t> begin_;
  std::vector<int> entries_;
};

}  // namespace relievo
