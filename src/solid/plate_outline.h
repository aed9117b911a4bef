#pragma once

#include "relievo/result.h"
#include "relievo/solid.h"

namespace relievo {

/// Computes the outline of the plate around a silhouette, in the silhouette's units, `mm` of them a
/// millimetre. The silhouette and its holes lie inside it by the margin; holes to hang it by lie
/// outside the silhouette. Fails with usage if there is no room for the hole. Precondition: the
/// base is not `none`.
Result<Outline> plate_outline(const Outline& silhouette, const SolidOptions& options, double mm);

}  // namespace relievo
