#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// Wanted edge length over the plane, on a regular grid: small beside samples of curves, growing
/// linearly with the distance from them, and nowhere below a sixteenth of a cell; and how many
/// regions cover each cell.
struct SizeField {
  Point2 origin;
  double cell = 1;
  int columns = 0;
  int rows = 0;
  double max_size = 1;       ///< upper bound of the size, and the step of the coarsest lattice
  std::vector<double> size;  ///< columns * rows, at cell centres
  std::vector<int> cover;    ///< columns * rows, regions that contain the cell's centre

  double size_at(Point2 p) const { return size[index(p)]; }
  int cover_at(Point2 p) const { return cover[index(p)]; }
  size_t index(Point2 p) const;
};

/// A sample of a curve with the spacing of the curve there.
struct CurveSample {
  Point2 position;
  double spacing = 1;
};

struct SizeOptions {
  double grading = 0.25;  ///< growth of the size per unit of distance
  double max_size = 1;    ///< upper bound of the size
  int cells = 400;        ///< along the longer side of the box
};

/// O(cells^2 + samples + rows * edges of the regions).
SizeField make_size_field(const std::vector<CurveSample>& samples,
                          const std::vector<Outline>& regions, const SizeOptions& options);

/// Points of nested hexagonal lattices whose density follows the field, inside at least one
/// region. O(points).
std::vector<Point2> lattice_points(const SizeField& field);

}  // namespace relievo
