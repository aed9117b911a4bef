#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// A uniform grid over some items that lists those in each cell, as two flat arrays.
class SegmentGrid {
 public:
  /// Lists `items` items; ends(i) returns two opposite corners of the box of item i. Makes square
  /// cells, about one per item and at most 4 * items + 16. O(items + entries).
  template <class Ends>
  SegmentGrid(size_t items, Ends ends) {
    Box2 box;
    for (size_t i = 0; i < items; ++i) {
      box.add(ends(i).first);
      box.add(ends(i).second);
    }
    make_cells(box, items);
    for (size_t i = 0; i < items; ++i)
      for_cells(ends(i).first, ends(i).second, 0, [&](size_t cell) { ++begin_[cell + 1]; });
    for (size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
    entries_.resize(begin_.back());
    std::vector<size_t> next(begin_.begin(), begin_.end() - 1);
    for (size_t i = 0; i < items; ++i)
      for_cells(ends(i).first, ends(i).second, 0,
                [&](size_t cell) { entries_[next[cell]++] = static_cast<int>(i); });
  }

  /// Calls visit(item) for each item of each cell within `margin` of the bounding box of segment
  /// ab, cell by cell; the items of a cell ascend.
  template <class Visit>
  void for_each_near(Point2 a, Point2 b, double margin, Visit visit) const {
    for_cells(a, b, margin, [&](size_t cell) {
      for (size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(entries_[k]);
    });
  }

 private:
  void make_cells(const Box2& box, size_t items) {
    const double w = std::max(box.max.x - box.min.x, 1e-300);
    const double h = std::max(box.max.y - box.min.y, 1e-300);
    const double longest = std::max(w, h);
    const double n = static_cast<double>(items) + 4;
    origin_ = box.min;
    cell_ = std::max(std::sqrt(w * h / n), longest / n);
    columns_ = static_cast<int>(w / cell_) + 1;
    rows_ = static_cast<int>(h / cell_) + 1;
    begin_.assign(static_cast<size_t>(columns_) * rows_ + 1, 0);
  }
  template <class Visit>
  void for_cells(Point2 a, Point2 b, double margin, Visit visit) const {
    const int x0 = column(std::min(a.x, b.x) - margin);
    const int x1 = column(std::max(a.x, b.x) + margin);
    const int y0 = row(std::min(a.y, b.y) - margin);
    const int y1 = row(std::max(a.y, b.y) + margin);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) visit(static_cast<size_t>(y) * columns_ + x);
  }
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
