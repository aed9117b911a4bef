#pragma once

#include <cstdint>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/maps.h"
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

}  // namespace relievo
