#pragma once

#include <cstdint>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// The lowest and highest of some heights, px; empty without heights.
struct HeightRange {
  double low = 0;
  double high = -1;
  bool empty() const { return high < low; }
  void add(const ImageF& height);
};

/// The heights of a depth map: height = offset + scale * value, for values from 1 to 65535.
struct DepthScale {
  double offset = 0;
  double scale = 0;
};

/// Returns the scale that spreads a range over the values of a depth map; 0 for an empty range.
DepthScale depth_scale(const HeightRange& range);

/// Return the pixels of encode_normal_map, encode_depth_map (at the given scale) and
/// encode_part_map, and of a share as 8 bits, where 255 is 1.
Image8 normal_image(const ReliefMaps& maps, bool green_down);
Image16 depth_image(const ImageF& height, const DepthScale& depth);
Result<Image16> part_image(const Image<int32_t>& part);
Image8 share_image(const ImageF& share);

/// Encodes a depth map as a file with its scale as texts.
Result<Bytes> encode_depth_image(const Image16& image, const DepthScale& depth);

/// Encodes the heights of a solid that lies on its back, in mm, as a 16-bit grey PNG for mills: 0
/// is the bed and everything beside the solid, 65535 the highest point, linear between. A pixel has
/// the height at its middle; the solid's box begins at the left and the lower edge. `px_per_mm` is
/// above 0; `base_mm` is the thickness below the lowest carved point. The file's texts are
/// "px_per_mm", "depth_mm" (the height of 65535), "base_mm", "width_mm" and "height_mm". Errors:
/// `bad_input` for a solid without height, `limit` above 16384 px a side.
Result<Bytes> encode_carve_map(const Model& solid, double px_per_mm, double base_mm);

}  // namespace relievo
