#pragma once

#include <vector>

#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/solid.h"
#include "solid/snap_sheet.h"

namespace relievo {

constexpr double cutter_wall = 0.8;  ///< mm, thickness of the wall that cuts dough

/// Returns the depth by which feet are sunk into a plate, mm.
inline double sunk_depth(const SolidOptions& options) { return 0.5 * options.thickness; }

/// Computes the placement that gives the whole its size. The plate of a figure is counted below its
/// feet only, not beyond its sides. The stamp inside a cutter is at most half as high as the wall.
/// Errors: `usage` if size, height, thickness and margin leave no room. O(T).
Result<GridPlacement> place_on_grid(const relief::VisibleSheet& sheet,
                                    const std::vector<relief::LimbSheet>& limbs,
                                    const SolidOptions& options);

/// Lets a placement grow by a factor, in depth too. The grid stays.
void grow(double factor, GridPlacement& placement);

}  // namespace relievo
