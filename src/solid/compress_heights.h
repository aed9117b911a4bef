#pragma once

#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"

namespace relievo {

/// Brings the depth of a sheet down to `share` of what it is, less where it must be: small forms
/// keep their slopes, large ones and steps give way [after Weyrich et al. 2007]. What lies behind
/// comes nearer by the same share. Heights and normals change, the plane does not. Fails with
/// internal where the heights cannot be computed. A few factorisations of the sheet.
/// Precondition: 0 < share < 1.
Status compress_heights(double share, relief::VisibleSheet& sheet);

}  // namespace relievo
