#pragma once

#include "relievo/bytes.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

struct CarveMapOptions {
  double px_per_mm = 10;  ///< > 0
  double base_mm = 2;     ///< what lies below the lowest carved point, to be told in the file
};

/// The heights of a solid that lies on its back, of a model in mm, as a 16-bit grey PNG for mills:
/// 0 is the bed, and where nothing is, 65535 the highest point, linear between. A pixel has the
/// height above its middle; the model's box begins at the left and the lower edge. The file's texts
/// are "px_per_mm", "depth_mm" (the height of 65535), "base_mm", "width_mm" and "height_mm".
/// Errors: `bad_input` for a model without height, `limit` above 16384 px a side.
Result<Bytes> encode_carve_map(const Model& solid, const CarveMapOptions& options = {});

}  // namespace relievo
