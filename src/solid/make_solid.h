#pragma once

#include <vector>

#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// Makes the solid between the surface in front and a flat back or the back of the parts, with
/// upright walls at steps: closed, a manifold and free of self-intersections, even if its
/// coordinates are rounded to single precision. With a flat back or a stand, the last part is the
/// base, for which the drawing gets a strip of plain colour at its lower end. `limbs` are mirrored
/// to the far side. Fails with usage if size, thickness and margin leave no room, options exclude
/// each other, or a limb does not become one solid with the figure. Near-linear in triangles.
Result<Solid> make_solid(relief::VisibleSheet sheet, const std::vector<relief::LimbSheet>& limbs,
                         Drawing drawing, const SolidOptions& options);

}  // namespace relievo
