#include "relief/finish/hidden_patches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/geometry/polygon.h"
#include "kernel/image/blur.h"
#include "kernel/image/compose.h"
#include "kernel/image/diffusion.h"
#include "kernel/image/morphology.h"
#include "kernel/image/pixel_box.h"
#include "relief/finish/fill_triangle.h"
#include "relief/finish/own_palette.h"
#include "relief/finish/place_tiles.h"

namespace relievo::relief {
namespace {

constexpr int longest_side = 512;  ///< px of the shrunk drawing
constexpr int ink_band = 4;        ///< px of it beside a part's outline that may be inked
constexpr int patch_margin = 2;    ///< px of it around hidden triangles, for filtering

/// Returns pixel art at its own size.
Image8 shrunk(const Drawing& drawing) {
  const Image8& rgba = drawing.rgba;
  const int longest = std::max(rgba.width, rgba.height);
  return shrink(rgba, drawing.pixel_art > 0 ? drawing.pixel_art
                                            : (longest + longest_side - 1) / longest_side);
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

/// Returns the pixels of a part that are far from its outline, where it may be inked: as far as
/// some of them are, and `band` at most. The drawing's edge is an outline too. With a margin of
/// a pixel around the box; empty if none of the part is seen.
Image8 inner_pixels(const Image16& front, const PixelBox& box, uint16_t part, int band) {
  Image8 own(box.width() + 2, box.height() + 2, 1);
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x)
      own.at(x - box.left + 1, y - box.top + 1) = front.at(x, y) == part ? 1 : 0;
  for (int far = band; far >= 0; --far) {
    Image8 inner = min_filter(own, far);
    if (std::find(inner.pixels.begin(), inner.pixels.end(), 1) != inner.pixels.end()) return inner;
  }
  return {};
}

/// Returns the seen colours of a part, weighted for pull_push; nothing if none of it is seen.
std::optional<ImageF> seen_of(const Image16& front, const Image8& drawing, const PixelBox& box,
                              uint16_t part, int band) {
  const Image8 inner = inner_pixels(front, box, part, band);
  if (inner.empty()) return std::nullopt;
  ImageF seen(box.width(), box.height(), 4);
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      if (inner.at(x + 1, y + 1) == 0) continue;
      const uint8_t* rgba = &drawing.at(box.left + x, box.top + y);
      for (int c = 0; c < 3; ++c) seen.at(x, y, c) = on_paper(rgba[c], rgba[3]);
      seen.at(x, y, 3) = 1;
    }
  return seen;
}

HiddenPatch cut_patch(const ImageF& filled, const PixelBox& whole, const PixelBox& hidden) {
  const int width = hidden.width();
  const int height = hidden.height();
  HiddenPatch patch{0, hidden.left, hidden.top, Image8(width, height, 3)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        patch.rgb.at(x, y, c) = static_cast<uint8_t>(
            std::lround(filled.at(hidden.left - whole.left + x, hidden.top - whole.top + y, c)));
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

/// The x and y of a patch's top left pixel in the picture.
using PatchPlace = std::array<int, 2>;

void paste_patch(const Image8& rgb, PatchPlace place, Image8& rgba) {
  const auto [left, top] = place;
  for (int y = 0; y < rgb.height; ++y)
    for (int x = 0; x < rgb.width; ++x) {
      for (int c = 0; c < 3; ++c) rgba.at(left + x, top + y, c) = rgb.at(x, y, c);
      rgba.at(left + x, top + y, 3) = 255;
    }
}

/// Gives the hidden triangles of parts vertices of their own, on their patches.
class PatchDresser {
 public:
  /// `drawing`: the size of the shrunk drawing that patches are pieces of. `uvs`: the model's
  /// texture coordinates on the drawing; the model's own are on the picture already.
  PatchDresser(Model& model, ImageSize drawing, ImageSize picture, const std::vector<Point2>& uvs)
      : model_(model),
        drawing_(drawing),
        picture_(picture),
        uvs_(uvs),
        taken_(uvs.size(), 0),
        copy_(uvs.size(), -1) {}

  /// Keeps the vertices of a part's triangles up to `end`.
  void keep(const ModelPart& part, int end) {
    for (int t = part.first_triangle; t < end; ++t)
      for (const int v : model_.triangles[t]) taken_[v] = 1;
  }

  void dress(const HiddenPatch& patch, PatchPlace place) {
    const ModelPart& part = model_.parts[patch.part];
    std::vector<int> used;
    for (int t = part.seen_end(); t < part.end(); ++t)
      for (int& v : model_.triangles[t]) {
        if (copy_[v] < 0) {
          used.push_back(v);
          copy_[v] = own_vertex(v);
          model_.uvs[copy_[v]] = on_patch(uvs_[v], patch, place);
        }
        v = copy_[v];
      }
    for (const int v : used) copy_[v] = -1;
  }

 private:
  Point2 on_patch(Point2 uv, const HiddenPatch& patch, PatchPlace place) const {
    return {(uv.x * drawing_.width - patch.x + place[0]) / picture_.width,
            (uv.y * drawing_.height - patch.y + place[1]) / picture_.height};
  }

  /// Returns the vertex itself if no other triangles use it, else a copy.
  int own_vertex(int vertex) {
    if (taken_[vertex] == 0) {
      taken_[vertex] = 1;
      return vertex;
    }
    const Point3 position = model_.positions[vertex];
    const Point3 normal = model_.normals[vertex];
    model_.positions.push_back(position);
    model_.normals.push_back(normal);
    model_.uvs.emplace_back();
    return static_cast<int>(model_.positions.size()) - 1;
  }

  Model& model_;
  ImageSize drawing_;
  ImageSize picture_;
  const std::vector<Point2>& uvs_;
  std::vector<uint8_t> taken_;  ///< by vertex of the drawing, whether triangles use it already
  std::vector<int> copy_;       ///< by vertex of the drawing, its copy for the present part, or -1
};

/// Moves texture coordinates from the drawing to the picture and hidden triangles to their patches.
/// `share`: of the picture's height that is the drawing.
void dress_parts(const HiddenPatches& found, const std::vector<PatchPlace>& places,
                 ImageSize picture, double share, Model& model) {
  const std::vector<Point2> uvs = model.uvs;
  for (Point2& uv : model.uvs) uv.y *= share;
  PatchDresser dresser(model, found.drawing, picture, uvs);
  std::vector<int> kept_end;
  for (const ModelPart& part : model.parts) kept_end.push_back(part.end());
  for (const HiddenPatch& patch : found.patches)
    kept_end[patch.part] = model.parts[patch.part].seen_end();
  for (size_t p = 0; p < model.parts.size(); ++p) dresser.keep(model.parts[p], kept_end[p]);
  for (size_t k = 0; k < places.size(); ++k) dresser.dress(found.patches[k], places[k]);
}

}  // namespace

HiddenPatches hidden_patches(const Model& model, const Drawing& drawing) {
  const auto hides = [](const ModelPart& part) { return part.hidden_count > 0; };
  if (drawing.rgba.empty() || std::none_of(model.parts.begin(), model.parts.end(), hides))
    return {};
  const Image8 small = shrunk(drawing);
  const bool keeps_colours = drawing.pixel_art > 0;
  HiddenPatches result{{small.width, small.height}, {}};
  const Image16 front = front_parts(model, result.drawing);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    if (!hides(model.parts[p])) continue;
    const ModelPart& part = model.parts[p];
    const PixelBox whole = box_around(model, part.first_triangle, part.end(), result.drawing);
    const auto seen =
        seen_of(front, small, whole, static_cast<uint16_t>(p + 1), keeps_colours ? 1 : ink_band);
    if (!seen) continue;
    ImageF filled = pull_push(*seen);
    if (keeps_colours) keep_palette(*seen, filled);
    const PixelBox hidden = box_around(model, part.seen_end(), part.end(), result.drawing);
    result.patches.push_back(cut_patch(filled, whole, hidden));
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

void lay_patches(const HiddenPatches& found, Model& model, Image8& rgba) {
  if (!found.patches.empty()) {
    const double drawn = rgba.height;
    std::vector<ImageSize> sizes;
    for (const HiddenPatch& patch : found.patches)
      sizes.push_back({patch.rgb.width, patch.rgb.height});
    const std::vector<PatchPlace> places = place_tiles(sizes, rgba.width, rgba.height);
    rgba.pixels.resize(static_cast<size_t>(rgba.width) * rgba.height * 4, 0);
    for (size_t k = 0; k < places.size(); ++k) paste_patch(found.patches[k].rgb, places[k], rgba);
    dress_parts(found, places, {rgba.width, rgba.height}, drawn / rgba.height, model);
  }
  for (ModelPart& part : model.parts) part.hidden_count = 0;
}

}  // namespace relievo::relief
