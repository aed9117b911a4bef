#pragma once

#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"

namespace relievo {

/// Compresses the depth of a sheet to `share` of it: small forms keep their slopes, large ones and
/// steps are flattened [after Weyrich et al. 2007]. The points behind come nearer by the same
/// share. Heights and normals change, x and y do not. Fails with internal if the heights cannot be
/// computed. Costs a few factorisations of the sheet.
/// Precondition: 0 < share < 1.
Status compress_heights(double share, relief::VisibleSheet& sheet);

}  // namespace relievo
