#include "relief/model/dress_hidden.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/image/compose.h"
#include "kernel/image/filters.h"
#include "relief/model/fill_triangle.h"
#include "relief/model/hidden_patches.h"

namespace relievo {
namespace {

/// Between the drawing and the patches, so that none shows at the rim of the other.
constexpr int gap = 8;

/// Where the left upper pixel of a patch lies in the picture.
struct PatchPlace {
  int x = 0;
  int y = 0;
};

/// Patches on shelves below the drawing, the high ones first; `height` grows to that of all.
std::vector<PatchPlace> place_patches(const std::vector<HiddenPatch>& patches, int width,
                                      int& height) {
  std::vector<int> order(patches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&patches](int a, int b) {
    return patches[a].rgb.height > patches[b].rgb.height;
  });
  std::vector<PatchPlace> places(patches.size());
  int x = width;
  int top = height;
  for (const int k : order) {
    const Image8& rgb = patches[k].rgb;
    if (x + rgb.width > width) {
      x = 0;
      top = height + gap;
      height = top + rgb.height;
    }
    places[k] = {x, top};
    x += rgb.width + gap;
  }
  return places;
}

void paste_patch(const Image8& rgb, PatchPlace place, Image8& rgba) {
  for (int y = 0; y < rgb.height; ++y)
    for (int x = 0; x < rgb.width; ++x) {
      for (int c = 0; c < 3; ++c) rgba.at(place.x + x, place.y + y, c) = rgb.at(x, y, c);
      rgba.at(place.x + x, place.y + y, 3) = 255;
    }
}

/// Has the hidden triangles of parts refer to vertices of their own, on their patches.
class PatchDresser {
 public:
  /// `drawing`: the size of the one that patches are pieces of. The model's texture coordinates
  /// are on the picture, `uvs` on the drawing.
  PatchDresser(Model& model, ImageSize drawing, ImageSize picture, const std::vector<Point2>& uvs)
      : model_(model),
        drawing_(drawing),
        picture_(picture),
        uvs_(uvs),
        taken_(uvs.size(), 0),
        copy_(uvs.size(), -1) {}

  /// Keeps the vertices of a part's triangles but the last `but` as they are.
  void keep(const ModelPart& part, int but) {
    for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count - but; ++t)
      for (const int v : model_.triangles[t]) taken_[v] = 1;
  }

  void dress(const HiddenPatch& patch, PatchPlace place) {
    const ModelPart& part = model_.parts[patch.part];
    const int end = part.first_triangle + part.triangle_count;
    std::vector<int> used;
    for (int t = end - part.hidden_count; t < end; ++t)
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
    return {(uv.x * drawing_.width - patch.x + place.x) / picture_.width,
            (uv.y * drawing_.height - patch.y + place.y) / picture_.height};
  }

  /// The vertex itself where nothing else needs it, else a copy.
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
  std::vector<uint8_t> taken_;  ///< of every vertex on the drawing
  std::vector<int> copy_;       ///< likewise, for the present part
};

/// `share`: of the picture's height that is the drawing.
void dress_parts(const HiddenPatches& found, const std::vector<PatchPlace>& places,
                 ImageSize picture, double share, Model& model) {
  const std::vector<Point2> uvs = model.uvs;
  for (Point2& uv : model.uvs) uv.y *= share;
  PatchDresser dresser(model, found.drawing, picture, uvs);
  std::vector<int> dressed(model.parts.size(), 0);
  for (const HiddenPatch& patch : found.patches)
    dressed[patch.part] = model.parts[patch.part].hidden_count;
  for (size_t p = 0; p < model.parts.size(); ++p) dresser.keep(model.parts[p], dressed[p]);
  for (size_t k = 0; k < places.size(); ++k) dresser.dress(found.patches[k], places[k]);
}

constexpr int blended = 2;  ///< px inside the outline that paper may blend into
constexpr int outside = 3;  ///< px beyond it that get paint, for what lies between pixels

using Colour = std::array<int, 3>;

constexpr Colour white = {255, 255, 255};
constexpr int dark = 3 * 128;  ///< the sum of a colour's channels up to which it is dark

/// The colour of a pixel as it looks on paper.
Colour seen_colour(const Image8& rgba, size_t i) {
  const uint8_t* p = &rgba.pixels[4 * i];
  return {on_paper(p[0], p[3]), on_paper(p[1], p[3]), on_paper(p[2], p[3])};
}

/// What the model stands on: the mean of what it leaves open where that is dark, else white paper.
Colour ground_of(const Image8& open, const Image8& rgba) {
  std::array<int64_t, 3> sum = {};
  int64_t count = 0;
  for (size_t i = 0; i < open.pixels.size(); ++i) {
    if (open.pixels[i] == 0) continue;
    const Colour colour = seen_colour(rgba, i);
    for (size_t c = 0; c < 3; ++c) sum[c] += colour[c];
    ++count;
  }
  if (count == 0 || sum[0] + sum[1] + sum[2] > dark * count) return white;
  Colour mean;
  for (size_t c = 0; c < 3; ++c) mean[c] = static_cast<int>(sum[c] / count);
  return mean;
}

/// Goes outwards from what is painted for certain, one pixel a step.
class PaintCarrier {
 public:
  PaintCarrier(const Image8& open, Image8& rgba)
      : open_(open), rgba_(rgba), ground_(ground_of(open, rgba)), known_(open) {
    const Image<int32_t> depth = squared_distance_to(open);
    for (size_t i = 0; i < known_.pixels.size(); ++i)
      known_.pixels[i] = depth.pixels[i] > blended * blended ? 1 : 0;
    const Image<int32_t> away = squared_distance_to(known_);
    constexpr int reach = blended + outside;
    for (size_t i = 0; i < known_.pixels.size(); ++i)
      if (known_.pixels[i] == 0 && away.pixels[i] <= reach * reach)
        waiting_.push_back(static_cast<int>(i));
  }

  void step() {
    std::vector<std::pair<int, Colour>> found;
    for (const int i : waiting_)
      if (known_.pixels[i] == 0) add_if_beside(i % known_.width, i / known_.width, found);
    for (const auto& [i, colour] : found) {
      known_.pixels[i] = 1;
      if (open_.pixels[i] != 0 || off_ground(colour) > off_ground(seen(i))) paint(i, colour);
    }
  }

 private:
  int off_ground(const Colour& colour) const {
    int sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += std::abs(colour[c] - ground_[c]);
    return sum;
  }

  Colour seen(int i) const { return seen_colour(rgba_, static_cast<size_t>(i)); }

  void paint(int i, const Colour& colour) {
    uint8_t* p = &rgba_.pixels[4 * static_cast<size_t>(i)];
    for (int c = 0; c < 3; ++c) p[c] = static_cast<uint8_t>(colour[c]);
    p[3] = 255;
  }

  void add_if_beside(int x, int y, std::vector<std::pair<int, Colour>>& found) const {
    Colour sum = {};
    int count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(known_.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(known_.width - 1, x + 1); ++u) {
        if (known_.at(u, v) == 0) continue;
        const Colour colour = seen(v * known_.width + u);
        for (int c = 0; c < 3; ++c) sum[c] += colour[c];
        ++count;
      }
    if (count == 0) return;
    for (int& value : sum) value = (value + count / 2) / count;
    found.emplace_back(y * known_.width + x, sum);
  }

  const Image8& open_;
  Image8& rgba_;
  Colour ground_;
  Image8 known_;
  std::vector<int> waiting_;  ///< pixels that can be reached
};

}  // namespace

DrawnModel dress_hidden(Model model, Drawing drawing) {
  const HiddenPatches found = hidden_patches(model, drawing);
  extend_paint(model, drawing.rgba);
  if (!found.patches.empty()) {
    Image8& rgba = drawing.rgba;
    const double drawn = rgba.height;
    const std::vector<PatchPlace> places = place_patches(found.patches, rgba.width, rgba.height);
    rgba.pixels.resize(static_cast<size_t>(rgba.width) * rgba.height * 4, 0);
    for (size_t k = 0; k < places.size(); ++k) paste_patch(found.patches[k].rgb, places[k], rgba);
    dress_parts(found, places, {rgba.width, rgba.height}, drawn / rgba.height, model);
  }
  for (ModelPart& part : model.parts) part.hidden_count = 0;
  return {std::move(model), std::move(drawing)};
}

void extend_paint(const Model& model, Image8& rgba) {
  if (rgba.empty()) return;
  const Image8 open = uncovered_pixels(model, {rgba.width, rgba.height});
  PaintCarrier carrier(open, rgba);
  for (int step = 0; step < blended + outside; ++step) carrier.step();
}

}  // namespace relievo
