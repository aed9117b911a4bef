#pragma once

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/maps.h"
#include "relievo/model.h"
#include "relievo/result.h"

namespace relievo {

/// Lowest and highest of some heights, px; empty where there are none.
struct HeightRange {
  double low = 0;
  double high = -1;
  bool empty() const { return high < low; }
  void add(const ImageF& height);
};

/// height = offset + scale * value, for the values 1 to 65535 of a depth map.
struct DepthScale {
  double offset = 0;
  double scale = 0;
};

/// The scale that spreads a range over the values of a depth map; 0 where it has no extent.
DepthScale depth_scale(const HeightRange& range);

/// What the files of encode_normal_map, encode_depth_map (of the given scale) and encode_part_map
/// hold, and 8 bits of a share, 255 is 1.
Image8 normal_image(const ReliefMaps& maps, bool green_down);
Image16 depth_image(const ImageF& height, const DepthScale& depth);
Result<Image16> part_image(const Image<int32_t>& part);
Image8 share_image(const ImageF& share);

/// A depth map as a file with its texts.
Result<Bytes> encode_depth_image(const Image16& image, const DepthScale& depth);

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
