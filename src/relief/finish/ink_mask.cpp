#include "relief/finish/ink_mask.h"

#include <array>

#include "relief/finish/fill_triangle.h"

namespace relievo::relief {
namespace {

constexpr double blend = 0.5;  ///< px beside ink that filtering reaches

/// Marks the band of ink between two points of an outline.
void mark_band(const OutlinePoint& a, const OutlinePoint& b, const Model& model, Image8& mask) {
  const double scale = mask.width / model.width;
  const auto at = [&](const OutlinePoint& p, double across) {
    const Point2 place = scale * p.place;
    return Point2{place.x + across * p.out.x, scale * model.height - (place.y + across * p.out.y)};
  };
  const Point2 corners[] = {at(a, -scale * a.inside - blend), at(a, scale * a.outside + blend),
                            at(b, -scale * b.inside - blend), at(b, scale * b.outside + blend)};
  const auto mark = [&mask](int x, int y) { mask.at(x, y) = 1; };
  const ImageSize size{mask.width, mask.height};
  for_each_pixel_inside({corners[0], corners[1], corners[2]}, size, mark);
  for_each_pixel_inside({corners[2], corners[1], corners[3]}, size, mark);
}

}  // namespace

Image8 ink_mask(const ContourInk& ink, const Model& model, const Image8& rgba) {
  Image8 mask(rgba.width, rgba.height, 1);
  for (const InkLine& line : ink.lines) {
    const size_t n = line.points.size();
    for (size_t i = line.closed ? 0 : 1; i < n; ++i)
      mark_band(line.points[(i + n - 1) % n], line.points[i], model, mask);
  }
  return mask;
}

}  // namespace relievo::relief
