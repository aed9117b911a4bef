#include "kernel/meshing/size_field.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

// Of a cell: as fine as a lattice that fills it may be. What is smaller is a speck beside which
// such a lattice would have points without end.
constexpr double finest = 1.0 / 16;

/// Growth from one cell to the next, beside and across.
struct Growth {
  double straight;
  double diagonal;
};

/// Takes over what the cells of the row before, which is done, allow.
void spread_from(const double* before, Growth growth, int columns, double* row) {
  for (int x = 0; x < columns; ++x) {
    const double aside = std::min(before[std::max(x - 1, 0)], before[std::min(x + 1, columns - 1)]);
    row[x] = std::min({row[x], before[x] + growth.straight, aside + growth.diagonal});
  }
}

// Two sweeps of an 8-neighbour distance transform: size(x) = min over y of size(y) + g |x - y|.
void spread(SizeField& field, double grading) {
  const Growth growth{grading * field.cell, grading * field.cell * std::sqrt(2.0)};
  const auto row = [&](int y) {
    return field.size.data() + static_cast<size_t>(y) * field.columns;
  };
  for (int y = 0; y < field.rows; ++y) {
    double* size = row(y);
    if (y > 0) spread_from(row(y - 1), growth, field.columns, size);
    for (int x = 1; x < field.columns; ++x)
      size[x] = std::min(size[x], size[x - 1] + growth.straight);
  }
  for (int y = field.rows - 1; y >= 0; --y) {
    double* size = row(y);
    if (y + 1 < field.rows) spread_from(row(y + 1), growth, field.columns, size);
    for (int x = field.columns - 2; x >= 0; --x)
      size[x] = std::min(size[x], size[x + 1] + growth.straight);
  }
}

struct Crossing {
  double x;
  int turn;
};

// Adds 1 to the cover of every cell whose centre lies in the region, row by row.
void add_cover(SizeField& field, const Outline& region) {
  std::vector<std::vector<Crossing>> crossings(field.rows);
  for (const Ring& ring : region)
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i];
      const Point2 b = ring[(i + 1) % ring.size()];
      const double low = (std::min(a.y, b.y) - field.origin.y) / field.cell - 0.5;
      const double high = (std::max(a.y, b.y) - field.origin.y) / field.cell - 0.5;
      const int first = std::max(0, static_cast<int>(std::ceil(low)));
      const int last = std::min(field.rows - 1, static_cast<int>(std::ceil(high)) - 1);
      for (int row = first; row <= last; ++row) {
        const double y = field.origin.y + (row + 0.5) * field.cell;
        crossings[row].push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
      }
    }
  for (int row = 0; row < field.rows; ++row) {
    std::vector<Crossing>& line = crossings[row];
    std::sort(line.begin(), line.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    int winding = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      winding += line[i].turn;
      if (winding == 0) continue;
      const double from = (line[i].x - field.origin.x) / field.cell - 0.5;
      const double to = (line[i + 1].x - field.origin.x) / field.cell - 0.5;
      for (int x = std::max(0, static_cast<int>(std::ceil(from))); x < field.columns && x < to; ++x)
        ++field.cover[static_cast<size_t>(row) * field.columns + x];
    }
  }
}

// Nested hexagonal lattices: the points of a coarser lattice are every other point of the finer
// one, so a rhombus that is fine enough contributes its own corner and nothing else.
class Lattice {
 public:
  explicit Lattice(const SizeField& field) : field_(field) {
    const double width = field.columns * field.cell;
    const double height = field.rows * field.cell;
    step_ = field.max_size;
    rows_ = static_cast<int>(height / (step_ * rise)) + 2;
    columns_ = static_cast<int>(width / step_ + 0.5 * rows_) + 2;
  }

  std::vector<Point2> points() {
    for (int j = 0; j < rows_; ++j)
      for (int i = -rows_ / 2 - 1; i < columns_; ++i) visit(i, j, step_, 0);
    return std::move(points_);
  }

 private:
  static constexpr double rise = 0.86602540378443865;  // sqrt(3)/2
  static constexpr int max_levels = 12;

  Point2 at(double i, double j, double step) const {
    return {field_.origin.x + (i + 0.5 * j) * step, field_.origin.y + j * rise * step};
  }

  bool outside(Point2 corner, double step) const {
    const double margin = 1.5 * step;
    return corner.x + margin < field_.origin.x || corner.y + margin < field_.origin.y ||
           corner.x > field_.origin.x + field_.columns * field_.cell ||
           corner.y > field_.origin.y + field_.rows * field_.cell;
  }

  void visit(int i, int j, double step, int level) {
    const Point2 corner = at(i, j, step);
    if (outside(corner, step)) return;
    const Point2 middle = at(i + 0.5, j + 0.5, step);
    const double wanted = std::min(field_.size_at(middle), field_.size_at(corner));
    if (step > wanted * 1.25 && level < max_levels) {
      for (int k = 0; k < 4; ++k) visit(2 * i + k % 2, 2 * j + k / 2, 0.5 * step, level + 1);
      return;
    }
    if (field_.cover_at(corner) > 0) points_.push_back(corner);
  }

  const SizeField& field_;
  double step_ = 1;
  int rows_ = 0;
  int columns_ = 0;
  std::vector<Point2> points_;
};

}  // namespace

size_t SizeField::index(Point2 p) const {
  const int x = std::clamp(static_cast<int>((p.x - origin.x) / cell), 0, columns - 1);
  const int y = std::clamp(static_cast<int>((p.y - origin.y) / cell), 0, rows - 1);
  return static_cast<size_t>(y) * columns + x;
}

SizeField make_size_field(const std::vector<CurveSample>& samples,
                          const std::vector<Outline>& regions, const SizeOptions& options) {
  Box2 box;
  for (const CurveSample& sample : samples) box.add(sample.position);
  SizeField field;
  const double width = box.max.x - box.min.x;
  const double height = box.max.y - box.min.y;
  field.cell = std::max({width, height, 1e-300}) / options.cells;
  field.origin = box.min;
  field.columns = static_cast<int>(width / field.cell) + 1;
  field.rows = static_cast<int>(height / field.cell) + 1;
  const size_t count = static_cast<size_t>(field.columns) * field.rows;
  field.max_size = options.max_size;
  field.size.assign(count, options.max_size);
  field.cover.assign(count, 0);
  for (const CurveSample& sample : samples) {
    double& size = field.size[field.index(sample.position)];
    size = std::min(size, std::max(sample.spacing, finest * field.cell));
  }
  spread(field, options.grading);
  for (const Outline& region : regions) add_cover(field, region);
  return field;
}

std::vector<Point2> lattice_points(const SizeField& field) { return Lattice(field).points(); }

}  // namespace relievo
