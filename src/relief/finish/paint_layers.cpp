#include "relief/finish/paint_layers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernel/image/diffusion.h"
#include "kernel/image/distance_transform.h"
#include "kernel/image/mask.h"
#include "kernel/image/outlines.h"
#include "relief/finish/own_palette.h"

namespace relievo::relief {
namespace {

/// Distance from another part within which colours may be ink of the outline between them, of the
/// drawing's longer side.
constexpr double ink_share = 0.006;

Outline scaled(const Outline& outline, double sx, double sy) {
  Outline out = outline;
  for (Ring& ring : out)
    for (Point2& p : ring) p = {sx * p.x, sy * p.y};
  return out;
}

/// Returns the part in front at every pixel, or -1.
Image<int32_t> front_parts(const std::vector<Mask>& masks, int width, int height) {
  Image<int32_t> front(width, height, 1, -1);
  for (size_t p = 0; p < masks.size(); ++p)
    for_each_pixel(masks[p], [&](int x, int y) { front.at(x, y) = static_cast<int32_t>(p); });
  return front;
}

/// Returns the squared distance of every pixel, px^2, from the nearest pixel beside another part.
Image<int32_t> border_distance(const Image<int32_t>& front) {
  Image8 border(front.width, front.height, 1);
  const auto compare = [&](int x, int y, int u, int v) {
    if (front.at(x, y) != front.at(u, v)) border.at(x, y) = border.at(u, v) = 1;
  };
  for (int y = 0; y < front.height; ++y)
    for (int x = 0; x < front.width; ++x) {
      if (x > 0) compare(x, y, x - 1, y);
      if (y > 0) compare(x, y, x, y - 1);
    }
  return squared_distance_to(border);
}

/// Returns the seen colours of a part at least ink_share from others, or all that are seen of it if
/// there are none; 4 channels, weighted by the last.
ImageF own_colours(const Mask& mask, const Image<int32_t>& front, const Image<int32_t>& from_border,
                   const Image8& rgba, int part) {
  const int reach =
      std::max(2, static_cast<int>(std::lround(ink_share * std::max(rgba.width, rgba.height))));
  ImageF colours(mask.inside.width, mask.inside.height, 4);
  bool any = false;
  for (const int least : {reach * reach, 0}) {
    if (any) break;
    for_each_pixel(mask, [&](int x, int y) {
      if (front.at(x, y) != part || rgba.at(x, y, 3) == 0) return;
      if (from_border.at(x, y) < least) return;
      any = true;
      for (int c = 0; c < 3; ++c)
        colours.at(x - mask.left, y - mask.top, c) = static_cast<float>(rgba.at(x, y, c));
      colours.at(x - mask.left, y - mask.top, 3) = 1;
    });
  }
  return colours;
}

/// Returns a part's pixels: those of the drawing where it is in front, `filled` behind others.
Image8 paint(const Mask& mask, const Image<int32_t>& front, const ImageF& filled,
             const Image8& rgba, int part) {
  Image8 layer(mask.inside.width, mask.inside.height, 4);
  for_each_pixel(mask, [&](int x, int y) {
    const int u = x - mask.left;
    const int v = y - mask.top;
    if (front.at(x, y) == part) {
      for (int c = 0; c < 4; ++c) layer.at(u, v, c) = rgba.at(x, y, c);
      return;
    }
    for (int c = 0; c < 3; ++c)
      layer.at(u, v, c) =
          static_cast<uint8_t>(std::lround(std::clamp(filled.at(u, v, c), 0.0F, 255.0F)));
    layer.at(u, v, 3) = 255;
  });
  return layer;
}

}  // namespace

std::vector<PaintedLayer> paint_layers(const Scene& scene, const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  std::vector<Mask> masks;
  for (const Part& part : scene.parts)
    masks.push_back(
        fill_outline(scaled(part.outline, rgba.width / scene.width, rgba.height / scene.height),
                     rgba.width, rgba.height));
  const Image<int32_t> front = front_parts(masks, rgba.width, rgba.height);
  const Image<int32_t> from_border = border_distance(front);
  std::vector<PaintedLayer> layers;
  for (size_t p = 0; p < masks.size(); ++p) {
    const int part = static_cast<int>(p);
    const ImageF seen = own_colours(masks[p], front, from_border, rgba, part);
    ImageF filled = pull_push(seen);
    if (drawing.pixel_art > 0) keep_palette(seen, filled);
    layers.push_back({scene.parts[p].id, masks[p].left, masks[p].top,
                      paint(masks[p], front, filled, rgba, part)});
  }
  return layers;
}

}  // namespace relievo::relief
