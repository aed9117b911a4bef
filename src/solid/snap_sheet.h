#pragma once

#include "relief/surface/visible_sheet.h"
#include "solid/height_field.h"

namespace relievo {

/// Where a sheet lies on the grid: grid = scale * (position - origin) / unit, rounded.
struct GridPlacement {
  double scale = 1;         ///< mm per px along the plate
  double height_scale = 1;  ///< mm per px upwards
  Point3 origin;            ///< px; comes to (0, 0, 0)
  double unit = 1;          ///< mm per step of the grid
  bool backed = false;      ///< whether the floor is the sheet's back, else the plate
};

/// The sheet as a height field, all heights counted from the plate. Where it changes its depth both
/// sides get the same points, those where the two profiles cross among them. Triangles that vanish
/// on the grid are left out; others may turn over there. Near-linear.
HeightField snap_sheet(const relief::VisibleSheet& sheet, const GridPlacement& placement);

}  // namespace relievo
