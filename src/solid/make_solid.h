#pragma once

#include "relief/model/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// Everything below what the front shows, down to a flat back or to what lies behind, with upright
/// walls where depth changes: closed, a manifold and free of self-intersections, also when its
/// coordinates are kept in single precision. The last part of its model is the base, if its back is
/// flat. The drawing has a strip of plain colour at its lower end for that. Fails with usage where
/// size, thickness and margin leave no room, or a hole or ring is asked for without a base.
/// Near-linear in triangles.
Result<Solid> make_solid(const VisibleSheet& given, const Drawing& drawing,
                         const SolidOptions& options);

}  // namespace relievo
