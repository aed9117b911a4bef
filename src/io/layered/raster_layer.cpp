#include "io/layered/raster_layer.h"

#include <array>
#include <cstdint>
#include <utility>

#include "kernel/base/text_rules.h"
#include "kernel/geometry/region.h"
#include "kernel/image/compose.h"
#include "kernel/image/level_contours.h"
#include "kernel/image/mask.h"

namespace relievo {
namespace {

/// Largest distance of a simplified outline from the exact one, px.
constexpr double outline_tolerance = 0.05;
/// Width of the rim whose colour tells whether a line runs along the outline, px.
constexpr int rim_width = 2;

/// Returns the layer without its pixels beyond the canvas.
RasterLayer cut_to_canvas(const RasterLayer& layer, const Image8& canvas) {
  const int64_t right = int64_t{layer.x} + layer.rgba.width;
  const int64_t bottom = int64_t{layer.y} + layer.rgba.height;
  const int left = std::max(layer.x, 0);
  const int top = std::max(layer.y, 0);
  RasterLayer cut;
  cut.x = left;
  cut.y = top;
  cut.opacity = layer.opacity;
  const int64_t width = std::min<int64_t>(right, canvas.width) - left;
  const int64_t height = std::min<int64_t>(bottom, canvas.height) - top;
  if (width <= 0 || height <= 0) return cut;
  cut.rgba = Image8(static_cast<int>(width), static_cast<int>(height), 4);
  for (int y = 0; y < cut.rgba.height; ++y) {
    const uint8_t* row = &layer.rgba.at(left - layer.x, y + top - layer.y);
    std::copy(row, row + 4 * width, &cut.rgba.at(0, y));
  }
  return cut;
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

LayerRole named_role(const std::string& name, LayerRole of_group) {
  if (name.starts_with("texture:")) return LayerRole::texture;
  if (name.starts_with("part:") && of_group != LayerRole::texture) return LayerRole::part;
  return of_group;
}

std::string plain_layer_name(const std::string& name, LayerRole role) {
  const bool marked = role == LayerRole::part && name.starts_with("part:");
  const std::string plain = marked ? name.substr(5) : name;
  return is_sound_id(plain) ? plain : "";
}

understanding::LayeredDrawing empty_drawing(int width, int height) {
  understanding::LayeredDrawing drawing;
  drawing.scene.width = width;
  drawing.scene.height = height;
  drawing.picture.rgba = Image8(width, height, 4);
  return drawing;
}

std::optional<understanding::Mark> opaque_mark(const RasterLayer& layer) {
  understanding::Mark mark;
  mark.region = opaque_region(layer);
  if (mark.region.empty()) return std::nullopt;
  set_color(layer, mark);
  return mark;
}

void put_layer(understanding::LayeredDrawing& drawing, const RasterLayer& layer) {
  const RasterLayer cut = cut_to_canvas(layer, drawing.picture.rgba);
  if (cut.rgba.empty()) return;
  lay_picture_over(drawing.picture.rgba, cut.x, cut.y, cut.rgba, cut.opacity);
  if (layer.role == LayerRole::texture) return;
  std::optional<understanding::Mark> found = opaque_mark(cut);
  if (!found) {
    drawing.warnings.push_back((layer.name.empty() ? "a layer" : "layer " + layer.name) +
                               " is less than half opaque everywhere and becomes no part");
    return;
  }
  understanding::Mark& mark = *found;
  if (layer.role == LayerRole::part) {
    drawing.scene.parts.push_back(part_of(layer, std::move(mark.region)));
    drawing.colors.push_back({{mark.color.r, mark.color.g, mark.color.b}});
    return;
  }
  mark.name = layer.name;
  mark.group = layer.group;
  drawing.marks.push_back(std::move(mark));
}

}  // namespace relievo
