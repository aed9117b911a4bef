#pragma once

#include "relievo/bytes.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the model as binary STL: mm, longest side `size_mm`, lying on z = 0 with the height of
/// the relief as Z, or `standing` with the drawing's up as Z, in the positive octant. Errors: as
/// check_exportable.
Result<Bytes> encode_stl(const Model& model, double size_mm = 100, bool standing = false);

}  // namespace relievo
