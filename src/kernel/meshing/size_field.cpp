#include "kernel/meshing/size_field.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

/// Smallest size over that of a cell. Around a smaller speck the lattice in a cell would have far
/// too many points.
constexpr double finest = 1.0 / 16;

/// Bounds the sizes of a row by those of the row before, given the growth to a cell beside and to
/// one across a corner.
void spread_from(const double* before, double straight, double diagonal, int columns, double* row) {
  for (int x = 0; x < columns; ++x) {
    const double aside = std::min(before[std::max(x - 1, 0)], before[std::min(x + 1, columns - 1)]);
    row[x] = std::min({row[x], before[x] + straight, aside + diagonal});
  }
}

/// Sets size(x) to the minimum over y of size(y) + grading |x - y|, by the two sweeps of an
/// 8-neighbour distance transform.
void spread(SizeField& field, double grading) {
  const double straight = grading * field.cell;
  const double diagonal = straight * std::sqrt(2.0);
  const auto row = [&](int y) {
    return field.size.data() + static_cast<size_t>(y) * field.columns;
  };
  for (int y = 0; y < field.rows; ++y) {
    double* size = row(y);
    if (y > 0) spread_from(row(y - 1), straight, diagonal, field.columns, size);
    for (int x = 1; x < field.columns; ++x) size[x] = std::min(size[x], size[x - 1] + straight);
  }
  for (int y = field.rows - 1; y >= 0; --y) {
    double* size = row(y);
    if (y + 1 < field.rows) spread_from(row(y + 1), straight, diagonal, field.columns, size);
    for (int x = field.columns - 2; x >= 0; --x)
      size[x] = std::min(size[x], size[x + 1] + straight);
  }
}

constexpr double rise = 0.86602540378443865;  ///< height of a row of a lattice over its step
constexpr int max_levels = 12;

/// Visits the rhombus (i, j) of a lattice with the given step. The points of a coarser lattice are
/// every other point of the finer one, so a rhombus that is fine enough contributes its own corner
/// and no other point.
void visit_rhombus(const SizeField& field, int i, int j, double step, int level,
                   std::vector<Point2>& points) {
  const auto at = [&](double column, double row) {
    return Point2{field.origin.x + (column + 0.5 * row) * step, field.origin.y + row * rise * step};
  };
  const Point2 corner = at(i, j);
  const double margin = 1.5 * step;
  if (corner.x + margin < field.origin.x || corner.y + margin < field.origin.y ||
      corner.x > field.origin.x + field.columns * field.cell ||
      corner.y > field.origin.y + field.rows * field.cell)
    return;
  const double wanted = std::min(field.size_at(at(i + 0.5, j + 0.5)), field.size_at(corner));
  if (step > wanted * 1.25 && level < max_levels) {
    for (int k = 0; k < 4; ++k)
      visit_rhombus(field, 2 * i + k % 2, 2 * j + k / 2, 0.5 * step, level + 1, points);
    return;
  }
  if (field.cover_at(corner) > 0) points.push_back(corner);
}

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
  for (const Outline& region : regions)
    for (const CellRun& run : cells_inside(region, field))
      for (int x = run.begin; x < run.end; ++x)
        ++field.cover[static_cast<size_t>(run.row) * field.columns + x];
  return field;
}

std::vector<Point2> lattice_points(const SizeField& field) {
  const double step = field.max_size;
  const int rows = static_cast<int>(field.rows * field.cell / (step * rise)) + 2;
  const int columns = static_cast<int>(field.columns * field.cell / step + 0.5 * rows) + 2;
  std::vector<Point2> points;
  for (int j = 0; j < rows; ++j)
    for (int i = -rows / 2 - 1; i < columns; ++i) visit_rhombus(field, i, j, step, 0, points);
  return points;
}

}  // namespace relievo
