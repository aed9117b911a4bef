#include "io/layered/raster_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/image/level_contours.h"
#include "kernel/image/mask.h"

namespace relievo {
namespace {

/// Largest distance of a simplified outline from the exact one, px.
constexpr double outline_tolerance = 0.05;
/// Width of the rim whose colour tells whether a line runs along the outline, px.
constexpr int rim_width = 2;

/// Returns the pixels whose four neighbours are all in the set too.
Image8 eroded(const Image8& set) {
  Image8 inner(set.width, set.height, 1);
  for (int y = 1; y + 1 < set.height; ++y)
    for (int x = 1; x + 1 < set.width; ++x)
      inner.at(x, y) =
          set.at(x, y) & set.at(x - 1, y) & set.at(x + 1, y) & set.at(x, y - 1) & set.at(x, y + 1);
  return inner;
}

/// Returns the mean of the layer's pixels in the set, alpha included; nothing for an empty set.
std::optional<Color> mean_color(const RasterLayer& layer, const Image8& set) {
  std::array<double, 4> sum = {};
  double count = 0;
  for (size_t i = 0; i < set.pixels.size(); ++i) {
    if (set.pixels[i] == 0) continue;
    for (size_t k = 0; k < 4; ++k) sum[k] += layer.rgba.pixels[4 * i + k] / 255.0;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return Color{sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count};
}

/// Sets the mark's colour to the mean of the layer's opaque pixels, without the rim where the layer
/// is wider than that, and whether the rim has another colour, like a line around a fill.
void set_color(const RasterLayer& layer, understanding::Mark& mark) {
  Image8 rim = mask_where(layer.rgba.width, layer.rgba.height, [&](size_t i) {
    return layer.opacity * layer.rgba.pixels[4 * i + 3] >= 127.5;
  });
  Image8 core = rim;
  for (int k = 0; k < rim_width; ++k) core = eroded(core);
  for (size_t i = 0; i < rim.pixels.size(); ++i)
    if (core.pixels[i] != 0) rim.pixels[i] = 0;
  const std::optional<Color> inner = mean_color(layer, core);
  const std::optional<Color> outer = mean_color(layer, rim);
  if (inner || outer) mark.color = inner ? *inner : *outer;
  mark.color.a *= layer.opacity;
  mark.outlined =
      inner && outer && color_distance(mark.color, *outer) > understanding::color_contrast;
}

Part part_of(const RasterLayer& layer, Region region) {
  Part part;
  part.id = layer.name;
  part.outline = std::move(region);
  part.c = layer.c.value_or(part.c);
  part.d = layer.d.value_or(part.d);
  part.flat = layer.flat.value_or(part.flat);
  part.lean = layer.lean.value_or(part.lean);
  return part;
}

}  // namespace

RasterLayer cut_to_canvas(RasterLayer layer, int width, int height) {
  const int left = std::max(layer.x, 0);
  const int top = std::max(layer.y, 0);
  const int64_t right = std::min<int64_t>(int64_t{layer.x} + layer.rgba.width, width);
  const int64_t bottom = std::min<int64_t>(int64_t{layer.y} + layer.rgba.height, height);
  const bool is_beside = right <= left || bottom <= top;
  if (!is_beside && right - left == layer.rgba.width && bottom - top == layer.rgba.height)
    return layer;
  Image8 cut;
  if (!is_beside) cut = Image8(static_cast<int>(right - left), static_cast<int>(bottom - top), 4);
  for (int y = 0; y < cut.height; ++y) {
    const uint8_t* row = &layer.rgba.at(left - layer.x, y + top - layer.y);
    std::copy(row, row + 4 * (right - left), &cut.at(0, y));
  }
  layer.x = left;
  layer.y = top;
  layer.rgba = std::move(cut);
  return layer;
}

Region opaque_region(const RasterLayer& layer) {
  ImageF alpha(layer.rgba.width, layer.rgba.height, 1);
  for (size_t i = 0; i < alpha.pixels.size(); ++i)
    alpha.pixels[i] = static_cast<float>(layer.opacity) * layer.rgba.pixels[4 * i + 3];
  Region region = level_contours(alpha, 127.5F);
  for (Ring& ring : region)
    for (Point2& p : ring) p = p + Point2{double(layer.x), double(layer.y)};
  return tidied(region, outline_tolerance, 1);
}

std::optional<understanding::Mark> opaque_mark(const RasterLayer& layer) {
  understanding::Mark mark;
  mark.region = opaque_region(layer);
  if (mark.region.empty()) return std::nullopt;
  set_color(layer, mark);
  mark.name = layer.name;
  mark.group = layer.group;
  return mark;
}

void add_layer(understanding::LayeredDrawing& drawing, const RasterLayer& layer) {
  std::optional<understanding::Mark> mark = opaque_mark(layer);
  if (!mark) {
    drawing.warnings.push_back((layer.name.empty() ? "a layer" : "layer " + layer.name) +
                               " is less than half opaque everywhere and becomes no part");
    return;
  }
  if (layer.role != LayerRole::part) return drawing.marks.push_back(std::move(*mark));
  drawing.scene.parts.push_back(part_of(layer, std::move(mark->region)));
  drawing.colors.push_back({{mark->color.r, mark->color.g, mark->color.b}});
}

void add_ink(understanding::LayeredDrawing& drawing, RasterLayer layer) {
  if (!white_is_neutral(layer.blending.mode)) return;
  for (size_t i = 0; i < layer.rgba.pixels.size(); i += 4) {
    uint8_t* pixel = &layer.rgba.pixels[i];
    pixel[3] = static_cast<uint8_t>(std::lround(alpha_alone(pixel, layer.blending.mode)));
  }
  std::optional<understanding::Mark> mark = opaque_mark(layer);
  if (!mark) return;
  mark->blends = true;
  drawing.marks.push_back(std::move(*mark));
}

}  // namespace relievo
