#include "relief/finish/hidden_patches.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "kernel/image/blur.h"
#include "kernel/image/compose.h"
#include "kernel/image/diffusion.h"
#include "relief/finish/fill_triangle.h"

namespace relievo::relief {
namespace {

constexpr int longest_side = 512;  ///< px of the shrunk drawing
constexpr int ink_band = 4;        ///< px of it beside a part's outline that may be inked
constexpr int patch_margin = 2;    ///< px of it around hidden triangles, for filtering

/// Pixels from (x0, y0) to before (x1, y1).
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  ImageSize size() const { return {x1 - x0, y1 - y0}; }
};

Image8 shrunk(const Image8& rgba) {
  const int longest = std::max(rgba.width, rgba.height);
  return shrink(rgba, (longest + longest_side - 1) / longest_side);
}

/// Returns the pixels around triangles [begin, end).
PixelBox box_around(const Model& model, int begin, int end, ImageSize size) {
  Box2 box;
  for (int t = begin; t < end; ++t)
    for (const int v : model.triangles[t]) box.add(model.uvs[v]);
  const auto pixel = [](double v, int length) {
    return std::clamp(static_cast<int>(std::floor(v * length)), 0, length - 1);
  };
  return {std::max(0, pixel(box.min.x, size.width) - patch_margin),
          std::max(0, pixel(box.min.y, size.height) - patch_margin),
          std::min(size.width, pixel(box.max.x, size.width) + patch_margin + 1),
          std::min(size.height, pixel(box.max.y, size.height) + patch_margin + 1)};
}

/// Returns the Chebyshev distance of each pixel from the pixels that are not the part's, those
/// beyond the drawing included, at most `most`.
Image8 depths(const Image16& front, const PixelBox& box, uint16_t part, int most) {
  const auto [width, height] = box.size();
  Image8 depth(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (front.at(box.x0 + x, box.y0 + y) == part) depth.at(x, y) = static_cast<uint8_t>(most);
  const auto get = [&depth](int x, int y) {
    const bool inside = x >= 0 && y >= 0 && x < depth.width && y < depth.height;
    return inside ? static_cast<int>(depth.at(x, y)) : 0;
  };
  const auto relax = [&](int x, int y, int step) {
    const int least =
        std::min({get(x + step, y), get(x - 1, y + step), get(x, y + step), get(x + 1, y + step)});
    depth.at(x, y) = static_cast<uint8_t>(std::min(get(x, y), least + 1));
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) relax(x, y, -1);
  for (int y = height - 1; y >= 0; --y)
    for (int x = width - 1; x >= 0; --x) relax(x, y, 1);
  return depth;
}

/// Returns the seen colours of a part, weighted for pull_push; nothing if none of it is seen.
std::optional<ImageF> seen_of(const Image16& front, const Image8& drawing, const PixelBox& box,
                              uint16_t part) {
  const Image8 depth = depths(front, box, part, ink_band + 1);
  const int deepest = *std::max_element(depth.pixels.begin(), depth.pixels.end());
  if (deepest == 0) return std::nullopt;
  ImageF seen(depth.width, depth.height, 4);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      if (depth.at(x, y) < deepest) continue;
      const uint8_t* rgba = &drawing.at(box.x0 + x, box.y0 + y);
      for (int c = 0; c < 3; ++c) seen.at(x, y, c) = on_paper(rgba[c], rgba[3]);
      seen.at(x, y, 3) = 1;
    }
  return seen;
}

HiddenPatch cut_patch(const ImageF& filled, const PixelBox& whole, const PixelBox& hidden) {
  const auto [width, height] = hidden.size();
  HiddenPatch patch{0, hidden.x0, hidden.y0, Image8(width, height, 3)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        patch.rgb.at(x, y, c) = static_cast<uint8_t>(
            std::lround(filled.at(hidden.x0 - whole.x0 + x, hidden.y0 - whole.y0 + y, c)));
  return patch;
}

/// Interpolates a channel of a patch at a place of the shrunk drawing.
uint8_t colour_at(const HiddenPatch& patch, Point2 place, int channel) {
  const Image8& rgb = patch.rgb;
  const double x = std::clamp(place.x - patch.x - 0.5, 0.0, rgb.width - 1.0);
  const double y = std::clamp(place.y - patch.y - 0.5, 0.0, rgb.height - 1.0);
  const int x0 = std::min(static_cast<int>(x), std::max(0, rgb.width - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, rgb.height - 2));
  const int x1 = std::min(x0 + 1, rgb.width - 1);
  const int y1 = std::min(y0 + 1, rgb.height - 1);
  const auto mix = [](double a, double b, double t) { return (1 - t) * a + t * b; };
  const double top = mix(rgb.at(x0, y0, channel), rgb.at(x1, y0, channel), x - x0);
  const double bottom = mix(rgb.at(x0, y1, channel), rgb.at(x1, y1, channel), x - x0);
  return static_cast<uint8_t>(std::lround(mix(top, bottom, y - y0)));
}

}  // namespace

HiddenPatches hidden_patches(const Model& model, const Drawing& drawing) {
  const auto hides = [](const ModelPart& part) { return part.hidden_count > 0; };
  if (drawing.rgba.empty() || std::none_of(model.parts.begin(), model.parts.end(), hides))
    return {};
  const Image8 small = shrunk(drawing.rgba);
  HiddenPatches result{{small.width, small.height}, {}};
  const Image16 front = front_parts(model, result.drawing);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    if (!hides(model.parts[p])) continue;
    const ModelPart& part = model.parts[p];
    const PixelBox whole = box_around(model, part.first_triangle, part.end(), result.drawing);
    const auto seen = seen_of(front, small, whole, static_cast<uint16_t>(p + 1));
    if (!seen) continue;
    const PixelBox hidden = box_around(model, part.seen_end(), part.end(), result.drawing);
    result.patches.push_back(cut_patch(pull_push(*seen), whole, hidden));
    result.patches.back().part = static_cast<int>(p);
  }
  return result;
}

std::vector<uint8_t> hidden_colours(const Model& model, const HiddenPatches& patches) {
  std::vector<uint8_t> colours(3 * model.positions.size(), 255);
  for (const HiddenPatch& patch : patches.patches) {
    const ModelPart& part = model.parts[patch.part];
    for (int t = part.seen_end(); t < part.end(); ++t)
      for (const int v : model.triangles[t]) {
        const Point2 uv = model.uvs[v];
        const Point2 place{uv.x * patches.drawing.width, uv.y * patches.drawing.height};
        for (int c = 0; c < 3; ++c) colours[3 * v + c] = colour_at(patch, place, c);
      }
  }
  return colours;
}

}  // namespace relievo::relief
