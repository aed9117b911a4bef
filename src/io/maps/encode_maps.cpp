#include "io/maps/encode_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/mesh/placement.h"
#include "relief/finish/fill_triangle.h"

namespace relievo {
namespace {

constexpr double highest_value = 65535;
constexpr double most_pixels = 16384;  ///< a side of a carve map

uint8_t encode_component(float n) {
  return static_cast<uint8_t>(std::lround(std::clamp(127.5 * n + 127.5, 0.0, 255.0)));
}

/// Raises the pixels below a triangle that faces up.
void raise_pixels(const std::array<Point3, 3>& corners, double depth, Image16& image) {
  const Point3 a = corners[0];
  const Point3 b = corners[1];
  const Point3 c = corners[2];
  const Point2 ab{b.x - a.x, b.y - a.y};
  const Point2 ac{c.x - a.x, c.y - a.y};
  // Rows run downwards, so the area of a triangle that faces up is negative.
  const double area = -cross(ab, ac);
  if (!(area > 0)) return;
  const std::array<Point2, 3> flat{Point2{a.x, a.y}, Point2{b.x, b.y}, Point2{c.x, c.y}};
  relief::for_each_pixel_inside(flat, {image.width, image.height}, [&](int x, int y) {
    const Point2 p{x + 0.5 - a.x, y + 0.5 - a.y};
    const double s = -cross(p, ac) / area;
    const double t = -cross(ab, p) / area;
    const double height = a.z + s * (b.z - a.z) + t * (c.z - a.z);
    const double value = std::clamp(highest_value * height / depth, 0.0, highest_value);
    uint16_t& pixel = image.at(x, y);
    pixel = std::max(pixel, static_cast<uint16_t>(std::lround(value)));
  });
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

Result<Bytes> encode_carve_map(const Model& solid, double px_per_mm, double base_mm) {
  const Box3 box = extent(solid);
  const Point3 sides = box.max - box.min;
  if (!(sides.z > 0)) return Error{ErrorCode::bad_input, "the solid has no height", ""};
  const double wide = std::ceil(px_per_mm * sides.x);
  const double high = std::ceil(px_per_mm * sides.y);
  if (!(std::max(wide, high) <= most_pixels))
    return Error{
        ErrorCode::limit,
        "the map would have more than 16384 px a side; choose a smaller size or resolution", ""};
  Image16 image(std::max(1, static_cast<int>(wide)), std::max(1, static_cast<int>(high)), 1);
  for (const std::array<int, 3>& triangle : solid.triangles) {
    std::array<Point3, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const Point3 p = solid.positions[triangle[k]] - box.min;
      corners[k] = {px_per_mm * p.x, image.height - px_per_mm * p.y, p.z};
    }
    raise_pixels(corners, sides.z, image);
  }
  return encode_png(image, {{"px_per_mm", shortest_text(px_per_mm)},
                            {"depth_mm", shortest_text(sides.z)},
                            {"base_mm", shortest_text(base_mm)},
                            {"width_mm", shortest_text(sides.x)},
                            {"height_mm", shortest_text(sides.y)}});
}

}  // namespace relievo
