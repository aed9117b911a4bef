#pragma once

#include "relievo/bytes.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Encodes the heights of a solid that lies on its back, in mm, as a 16-bit grey PNG for mills: 0
/// is the bed and everything beside the solid, 65535 the highest point, linear between. A pixel has
/// the height at its middle; the solid's box begins at the left and the lower edge. `px_per_mm` is
/// above 0; `base_mm` is the thickness below the lowest carved point. The file's texts are
/// "px_per_mm", "depth_mm" (the height of 65535), "base_mm", "width_mm" and "height_mm". Errors:
/// `bad_input` for a solid without height, `limit` above 16384 px a side.
Result<Bytes> encode_carve_map(const Model& solid, double px_per_mm, double base_mm);

}  // namespace relievo
