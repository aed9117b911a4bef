#pragma once

#include "io/svg/svg_document.h"
#include "relievo/result.h"

namespace relievo {

/// Writes what style attributes state of the geometry of shapes (x, width, r, d, ...) into the
/// attributes of these names, and each transform with units, an origin or a reference box, or of
/// several properties, as one matrix into the transform attribute. A transform that cannot be read
/// is taken away, with a warning. Errors: `limit` where the boxes of objects take too much work.
Status resolve_geometry(SvgDocument& document);

}  // namespace relievo
