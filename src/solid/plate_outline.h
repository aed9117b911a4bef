#pragma once

#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// The outline of the plate around a silhouette, in its units; `mm` is a millimetre in them.
/// Everything that the silhouette's rings surround lies inside by the margin, and the rings of
/// holes to hang it by lie outside of the silhouette. Fails with usage where a hole has no room.
/// Precondition: the base is not `none`.
Result<Outline> plate_outline(const Outline& silhouette, const SolidOptions& options, double mm);

}  // namespace relievo
