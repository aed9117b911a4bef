#include "relief/model/paint_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernel/image/mask.h"
#include "kernel/image/outlines.h"
#include "kernel/image/pull_push.h"

namespace relievo {
namespace {

/// Of the longer side: colours so near to another part may be ink of the outline between them.
constexpr double ink_share = 0.006;

Outline scaled(const Outline& outline, double sx, double sy) {
  Outline out = outline;
  for (Ring& ring : out)
    for (Point2& p : ring) p = {sx * p.x, sy * p.y};
  return out;
}

/// The part in front at every pixel, -1 where there is none.
Image<int32_t> front_parts(const std::vector<Mask>& masks, int width, int height) {
  Image<int32_t> front(width, height, 1, -1);
  for (size_t p = 0; p < masks.size(); ++p)
    for_each_pixel(masks[p], [&](int x, int y) { front.at(x, y) = static_cast<int32_t>(p); });
  return front;
}

/// Whether all pixels of the square around a pixel that are some part's are this part's.
bool is_inside(const Image<int32_t>& front, int x, int y, int reach) {
  const int32_t part = front.at(x, y);
  for (int v = std::max(0, y - reach); v <= std::min(front.height - 1, y + reach); ++v)
    for (int u = std::max(0, x - reach); u <= std::min(front.width - 1, x + reach); ++u)
      if (front.at(u, v) != part) return false;
  return true;
}

/// The colours of a part that are surely its own, 4 channels weighted by the last; all that are
/// seen of it where none is.
ImageF own_colours(const Mask& mask, const Image<int32_t>& front, const Image8& rgba, int part,
                   int reach) {
  ImageF colours(mask.inside.width, mask.inside.height, 4);
  bool any = false;
  for (const int around : {reach, 0}) {
    if (any) break;
    for_each_pixel(mask, [&](int x, int y) {
      if (front.at(x, y) != part || rgba.at(x, y, 3) == 0) return;
      if (!is_inside(front, x, y, around)) return;
      any = true;
      for (int c = 0; c < 3; ++c)
        colours.at(x - mask.left, y - mask.top, c) = static_cast<float>(rgba.at(x, y, c));
      colours.at(x - mask.left, y - mask.top, 3) = 1;
    });
  }
  return colours;
}

Image8 paint(const Mask& mask, const Image<int32_t>& front, const Image8& rgba, int part) {
  const int reach =
      std::max(2, static_cast<int>(std::lround(ink_share * std::max(rgba.width, rgba.height))));
  const ImageF filled = pull_push(own_colours(mask, front, rgba, part, reach));
  Image8 layer(rgba.width, rgba.height, 4);
  for_each_pixel(mask, [&](int x, int y) {
    if (front.at(x, y) == part) {
      for (int c = 0; c < 4; ++c) layer.at(x, y, c) = rgba.at(x, y, c);
      return;
    }
    for (int c = 0; c < 3; ++c) {
      const float value = filled.at(x - mask.left, y - mask.top, c);
      layer.at(x, y, c) = static_cast<uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
    }
    layer.at(x, y, 3) = 255;
  });
  return layer;
}

}  // namespace

std::vector<PaintedLayer> paint_layers(const Scene& scene, const Image8& rgba) {
  std::vector<Mask> masks;
  for (const Part& part : scene.parts)
    masks.push_back(
        fill_outline(scaled(part.outline, rgba.width / scene.width, rgba.height / scene.height),
                     rgba.width, rgba.height));
  const Image<int32_t> front = front_parts(masks, rgba.width, rgba.height);
  std::vector<PaintedLayer> layers;
  for (size_t p = 0; p < masks.size(); ++p)
    layers.push_back({scene.parts[p].id, paint(masks[p], front, rgba, static_cast<int>(p))});
  return layers;
}

}  // namespace relievo
