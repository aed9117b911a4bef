#pragma once

#include "relief/surface/visible_sheet.h"
#include "solid/height_field.h"

namespace relievo {

/// The placement of a sheet on the grid: grid = scale * (position - origin) / unit, rounded.
struct GridPlacement {
  double scale = 1;         ///< mm per px along the plate
  double height_scale = 1;  ///< mm per px upwards
  Point3 origin;            ///< px, placed at (0, 0, 0)
  double unit = 1;          ///< mm per grid step
  bool backed = false;      ///< whether the floor is the sheet's back instead of the plate
};

/// Converts a sheet to a height field, all heights counted from the plate. At steps both sides get
/// the same points, among them those at which the two profiles cross. Triangles that vanish on the
/// grid are left out; others may be turned over by rounding (repair_plane). Near-linear.
HeightField snap_sheet(const relief::VisibleSheet& sheet, const GridPlacement& placement);

}  // namespace relievo
