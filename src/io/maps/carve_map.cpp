#include "io/maps/carve_map.h"

#include <algorithm>
#include <cmath>

#include "io/files/number_text.h"
#include "io/image/png_encode.h"
#include "io/mesh/placement.h"
#include "relief/finish/fill_triangle.h"

namespace relievo {
namespace {

constexpr double white = 65535;
constexpr double most_pixels = 16384;

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
    const double value = std::clamp(white * height / depth, 0.0, white);
    uint16_t& pixel = image.at(x, y);
    pixel = std::max(pixel, static_cast<uint16_t>(std::lround(value)));
  });
}

}  // namespace

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
