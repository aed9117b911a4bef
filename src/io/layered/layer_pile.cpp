#include "io/layered/layer_pile.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/base/text_rules.h"
#include "kernel/geometry/region.h"
#include "kernel/image/compose.h"
#include "kernel/image/level_contours.h"
#include "understanding/marks/figures.h"
#include "understanding/marks/part_cover.h"
#include "understanding/marks/propose_parts.h"

namespace relievo {
namespace {

/// Outlines of layers are simplified by no more than this, px.
constexpr double outline_tolerance = 0.05;

/// The layer as far as it lies on the canvas.
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

void paint(Image8& canvas, const RasterLayer& layer) {
  for (int y = 0; y < layer.rgba.height; ++y)
    for (int x = 0; x < layer.rgba.width; ++x)
      lay_over(&canvas.at(x + layer.x, y + layer.y), &layer.rgba.at(x, y), layer.opacity);
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

/// Width of what is taken for the rim, px.
constexpr int rim_width = 2;

/// Pixels of an image, 1 or 0 each.
using Mask = std::vector<char>;

Mask opaque_pixels(const RasterLayer& layer) {
  Mask mask(layer.rgba.pixels.size() / 4);
  for (size_t i = 0; i < mask.size(); ++i)
    mask[i] = layer.opacity * layer.rgba.pixels[4 * i + 3] >= 127.5 ? 1 : 0;
  return mask;
}

/// The pixels whose four neighbours are all in the mask.
Mask eroded(const Mask& mask, int width, int height) {
  Mask inner(mask.size());
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      const size_t i = static_cast<size_t>(y) * width + x;
      inner[i] = mask[i] & mask[i - 1] & mask[i + 1] & mask[i - width] & mask[i + width];
    }
  return inner;
}

struct MeanColor {
  double sum[4] = {0, 0, 0, 0};
  double count = 0;

  void add(const uint8_t* rgba) {
    for (int k = 0; k < 4; ++k) sum[k] += rgba[k] / 255.0;
    ++count;
  }

  Color mean() const { return {sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count}; }
};

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

LayerPile empty_pile(int width, int height) {
  LayerPile pile;
  pile.rgba = Image8(width, height, 4);
  return pile;
}

void put_layer(LayerPile& pile, const RasterLayer& layer) {
  const RasterLayer cut = cut_to_canvas(layer, pile.rgba);
  if (cut.rgba.empty()) return;
  paint(pile.rgba, cut);
  if (layer.role == LayerRole::texture) return;
  Region region = opaque_region(cut);
  if (region.empty()) {
    pile.notes.push_back((layer.name.empty() ? "a layer" : "layer " + layer.name) +
                         " is nowhere half opaque and is no part");
    return;
  }
  if (layer.role == LayerRole::part) {
    pile.parts.push_back(part_of(layer, std::move(region)));
    const Color inner = color_of(cut).inner;
    pile.colors.push_back({{inner.r, inner.g, inner.b}});
    return;
  }
  const LayerColor color = color_of(cut);
  understanding::Mark mark;
  mark.name = layer.name;
  mark.group = layer.group;
  mark.region = std::move(region);
  mark.color = color.inner;
  mark.outlined = color.outlined;
  pile.marks.push_back(std::move(mark));
}

Result<LayeredDrawing> scene_of_pile(LayerPile pile) {
  LayeredDrawing result;
  result.warnings = std::move(pile.notes);
  result.scene.width = pile.rgba.width;
  result.scene.height = pile.rgba.height;
  result.proposed = pile.parts.empty();
  if (result.proposed) {
    understanding::FigureList figures = understanding::group_figures(
        std::move(pile.marks), {{0, 0}, {result.scene.width, result.scene.height}});
    understanding::ProposedParts proposed = understanding::propose_parts(figures);
    result.scene.parts = std::move(proposed.parts);
    result.colors = std::move(proposed.colors);
    result.warnings.insert(result.warnings.end(), figures.notes.begin(), figures.notes.end());
  } else {
    result.scene.parts = std::move(pile.parts);
    result.colors = std::move(pile.colors);
    understanding::make_ids_unique(result.scene.parts);
  }
  if (result.scene.parts.empty())
    return Error{ErrorCode::bad_input, "no layer has anything opaque on the canvas", "layers"};
  result.drawing.rgba = std::move(pile.rgba);
  return result;
}

LayerColor color_of(const RasterLayer& layer) {
  const Mask mask = opaque_pixels(layer);
  Mask core = mask;
  for (int k = 0; k < rim_width; ++k) core = eroded(core, layer.rgba.width, layer.rgba.height);
  MeanColor inner;
  MeanColor rim;
  for (size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) (core[i] ? inner : rim).add(&layer.rgba.pixels[4 * i]);
  LayerColor color;
  if (inner.count == 0) {
    if (rim.count > 0) color.inner = rim.mean();
    color.inner.a *= layer.opacity;
    return color;
  }
  color.inner = inner.mean();
  color.inner.a *= layer.opacity;
  color.outlined =
      rim.count > 0 && color_distance(color.inner, rim.mean()) > understanding::color_contrast;
  return color;
}

}  // namespace relievo
