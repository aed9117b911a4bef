#include "io/maps/encode_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/number_text.h"
#include "io/image/png_encode.h"

namespace relievo {
namespace {

constexpr double highest_value = 65535;

uint8_t encode_component(float n) {
  return static_cast<uint8_t>(std::lround(std::clamp(127.5 * n + 127.5, 0.0, 255.0)));
}

}  // namespace

void HeightRange::add(const ImageF& height) {
  for (const float h : height.pixels) {
    if (!std::isfinite(h)) continue;
    const auto value = static_cast<double>(h);
    if (empty()) low = high = value;
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

DepthScale depth_scale(const HeightRange& range) {
  if (range.empty()) return {};
  const double scale = (range.high - range.low) / (highest_value - 1);
  return {scale > 0 ? range.low - scale : range.low, scale};
}

Image8 normal_image(const ReliefMaps& maps, bool green_down) {
  Image8 image(maps.normal.width, maps.normal.height, 3);
  const float up = green_down ? -1.0F : 1.0F;
  for (size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = encode_component(maps.normal.pixels[i]);
    image.pixels[i + 1] = encode_component(up * maps.normal.pixels[i + 1]);
    image.pixels[i + 2] = encode_component(maps.normal.pixels[i + 2]);
  }
  return image;
}

Image16 depth_image(const ImageF& heights, const DepthScale& depth) {
  Image16 image(heights.width, heights.height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    const auto height = static_cast<double>(heights.pixels[i]);
    if (!std::isfinite(height)) continue;
    const double value = depth.scale > 0 ? (height - depth.offset) / depth.scale : highest_value;
    image.pixels[i] = static_cast<uint16_t>(std::lround(std::clamp(value, 1.0, highest_value)));
  }
  return image;
}

Result<Image16> part_image(const Image<int32_t>& parts) {
  Image16 image(parts.width, parts.height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    const int32_t part = parts.pixels[i];
    if (part >= std::numeric_limits<uint16_t>::max())
      return Error{ErrorCode::limit, "a part map holds at most 65535 parts", ""};
    image.pixels[i] = static_cast<uint16_t>(std::max(part, -1) + 1);
  }
  return image;
}

Image8 share_image(const ImageF& share) {
  Image8 image(share.width, share.height, 1);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] =
        static_cast<uint8_t>(std::lround(255 * std::clamp(share.pixels[i], 0.0F, 1.0F)));
  return image;
}

Result<Bytes> encode_depth_image(const Image16& image, const DepthScale& depth) {
  return encode_png(image, {{"height_scale", shortest_text(depth.scale)},
                            {"height_offset", shortest_text(depth.offset)}});
}

Result<Bytes> encode_normal_map(const ReliefMaps& maps, bool green_down) {
  return encode_png(normal_image(maps, green_down));
}

Result<Bytes> encode_depth_map(const ReliefMaps& maps) {
  HeightRange range;
  range.add(maps.height);
  const DepthScale depth = depth_scale(range);
  return encode_depth_image(depth_image(maps.height, depth), depth);
}

Result<Bytes> encode_part_map(const ReliefMaps& maps) {
  const auto image = part_image(maps.part);
  if (!image) return image.error();
  return encode_png(*image);
}

}  // namespace relievo
