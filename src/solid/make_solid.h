#pragma once

#include <vector>

#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// Everything below what the front shows, down to a flat back or to what lies behind, with upright
/// walls where depth changes: closed, a manifold and free of self-intersections, also when its
/// coordinates are kept in single precision. The last part of its model is the base, if its back is
/// flat. The drawing has a strip of plain colour at its lower end for that. `limbs` are on the far
/// side too. Fails with usage where size, thickness and margin leave no room, options exclude each
/// other, or a limb does not become one solid with the figure. Near-linear in triangles.
Result<Solid> make_solid(const relief::VisibleSheet& given,
                         const std::vector<relief::LimbSheet>& limbs, const Drawing& drawing,
                         const SolidOptions& options);

inline Result<Solid> make_solid(const relief::VisibleSheet& given, const Drawing& drawing,
                                const SolidOptions& options) {
  return make_solid(given, {}, drawing, options);
}

}  // namespace relievo
