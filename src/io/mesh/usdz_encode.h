#pragma once

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the model as a USDZ package, which phones show: one mesh with one material in USD's text
/// form, metres, Y up, front towards +Z, standing on y = 0, longest side `size_mm`. The drawing
/// (may be null) is its texture. The data of its entries lie at multiples of 64 bytes, as the
/// format demands. The same input gives the same bytes. Errors: as check_exportable; `limit` above
/// 4 GB.
Result<Bytes> encode_usdz(const Model& model, const Drawing* drawing, double size_mm = 100);

}  // namespace relievo
