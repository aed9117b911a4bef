#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/number_text.h"
#include "io/image/png_encode.h"
#include "relievo/maps.h"

namespace relievo {
namespace {

constexpr double highest_value = 65535;

uint8_t encode_component(float n) {
  return static_cast<uint8_t>(std::lround(std::clamp(127.5 * n + 127.5, 0.0, 255.0)));
}

struct Range {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  bool empty() const { return high < low; }
};

Range range_of(const ImageF& height) {
  Range range;
  for (const float h : height.pixels) {
    if (!std::isfinite(h)) continue;
    range.low = std::min(range.low, static_cast<double>(h));
    range.high = std::max(range.high, static_cast<double>(h));
  }
  return range;
}

/// height = offset + scale * value
struct DepthScale {
  double offset = 0;
  double scale = 0;
};

DepthScale depth_scale(const Range& range) {
  if (range.empty()) return {};
  const double scale = (range.high - range.low) / (highest_value - 1);
  return {scale > 0 ? range.low - scale : range.low, scale};
}

}  // namespace

Result<Bytes> encode_normal_map(const ReliefMaps& maps, GreenAxis green) {
  Image8 image(maps.normal.width, maps.normal.height, 3);
  const float up = green == GreenAxis::up ? 1.0F : -1.0F;
  for (size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = encode_component(maps.normal.pixels[i]);
    image.pixels[i + 1] = encode_component(up * maps.normal.pixels[i + 1]);
    image.pixels[i + 2] = encode_component(maps.normal.pixels[i + 2]);
  }
  return encode_png(image);
}

Result<Bytes> encode_depth_map(const ReliefMaps& maps) {
  const DepthScale depth = depth_scale(range_of(maps.height));
  Image16 image(maps.height.width, maps.height.height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    const double height = static_cast<double>(maps.height.pixels[i]);
    if (!std::isfinite(height)) continue;
    const double value = depth.scale > 0 ? (height - depth.offset) / depth.scale : highest_value;
    image.pixels[i] = static_cast<uint16_t>(std::lround(std::clamp(value, 1.0, highest_value)));
  }
  return encode_png(image, {{"height_scale", shortest_text(depth.scale)},
                            {"height_offset", shortest_text(depth.offset)}});
}

Result<Bytes> encode_part_map(const ReliefMaps& maps) {
  Image16 image(maps.part.width, maps.part.height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    const int32_t part = maps.part.pixels[i];
    if (part >= std::numeric_limits<uint16_t>::max())
      return Error{ErrorCode::limit, "a part map holds at most 65535 parts", ""};
    image.pixels[i] = static_cast<uint16_t>(std::max(part, -1) + 1);
  }
  return encode_png(image);
}

}  // namespace relievo
