#pragma once

#include <vector>

#include "kernel/geometry/polyline.h"

namespace relievo {

/// The wanted edge length over the plane on a regular grid: small near samples of curves, growing
/// linearly with the distance from them, and never below a sixteenth of a cell. Also the number of
/// regions over each cell.
struct SizeField : CellGrid {
  double max_size = 1;       ///< upper bound of the size, and the step of the coarsest lattice
  std::vector<double> size;  ///< columns * rows, wanted edge length at the centre of each cell
  std::vector<int> cover;    ///< columns * rows, number of regions that contain the centre

  double size_at(Point2 p) const { return size[index(p)]; }
  int cover_at(Point2 p) const { return cover[index(p)]; }
  /// Returns the index of the cell of p; outside the grid that of the nearest cell.
  size_t index(Point2 p) const;
};

/// A sample of a curve with the spacing of the curve there.
struct CurveSample {
  Point2 position;
  double spacing = 1;
};

/// How a size field is made.
struct SizeOptions {
  double grading = 0.25;  ///< growth of the size per unit of distance
  double max_size = 1;    ///< upper bound of the size
  int cells = 400;        ///< number along the longer side of the samples' box
};

/// Makes the size field around the samples. O(cells^2 + samples + rows * edges of the regions).
SizeField make_size_field(const std::vector<CurveSample>& samples,
                          const std::vector<Outline>& regions, const SizeOptions& options);

/// Returns points of nested hexagonal lattices whose spacing follows the field, inside at least one
/// region. O(points).
std::vector<Point2> lattice_points(const SizeField& field);

}  // namespace relievo
