#include "io/layered/compose_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "kernel/image/blend.h"
#include "kernel/image/compose.h"
#include "kernel/image/pixel_box.h"

namespace relievo {
namespace {

using understanding::LayeredDrawing;

constexpr int no_group = -1;

PixelBox box_of(const RasterLayer& layer) {
  return {layer.x, layer.y, layer.x + layer.rgba.width, layer.y + layer.rgba.height};
}

/// Makes the sheet as large as it and the box need together.
void extend(RasterLayer& sheet, const PixelBox& box) {
  const PixelBox own = sheet.rgba.empty() ? box : box_of(sheet);
  const PixelBox all = {std::min(own.left, box.left), std::min(own.top, box.top),
                        std::max(own.right, box.right), std::max(own.bottom, box.bottom)};
  if (!sheet.rgba.empty() && all.width() == sheet.rgba.width && all.height() == sheet.rgba.height)
    return;
  Image8 larger(all.width(), all.height(), 4);
  if (!sheet.rgba.empty()) paste(larger, sheet.x - all.left, sheet.y - all.top, sheet.rgba);
  sheet.rgba = std::move(larger);
  sheet.x = all.left;
  sheet.y = all.top;
}

/// Returns whether the layer changes the sheet also where it has no pixels itself.
bool erases_beside(CoverMode cover) {
  return cover == CoverMode::source_in || cover == CoverMode::below_in ||
         cover == CoverMode::below_atop;
}

bool may_add(CoverMode cover) { return cover == CoverMode::over || cover == CoverMode::below_atop; }

/// Lays the layer on the sheet.
void lay(RasterLayer& sheet, const RasterLayer& layer) {
  const CoverMode cover = layer.blending.cover;
  if (may_add(cover) && !layer.rgba.empty()) extend(sheet, box_of(layer));
  if (sheet.rgba.empty()) return;
  if (layer.blending.is_plain())
    return lay_picture_over(sheet.rgba, layer.x - sheet.x, layer.y - sheet.y, layer.rgba,
                            layer.opacity);
  const PixelBox whole = box_of(sheet);
  const PixelBox own = box_of(layer);
  const PixelBox box = erases_beside(cover) ? whole : intersect(whole, own);
  const std::array<uint8_t, 4> nothing = {};
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x) {
      const uint8_t* above =
          own.contains(x, y) ? &layer.rgba.at(x - layer.x, y - layer.y) : nothing.data();
      blend_over(&sheet.rgba.at(x - sheet.x, y - sheet.y), above, layer.opacity, layer.blending);
    }
}

/// Moves the pixels of `after` back towards those of `before`, which are transparent beyond it.
void fade(RasterLayer& after, const RasterLayer& before, double opacity) {
  const PixelBox old = box_of(before);
  const std::array<uint8_t, 4> nothing = {};
  for (int y = 0; y < after.rgba.height; ++y)
    for (int x = 0; x < after.rgba.width; ++x) {
      uint8_t* to = &after.rgba.at(x, y);
      const int u = x + after.x;
      const int v = y + after.y;
      const uint8_t* from =
          old.contains(u, v) ? &before.rgba.at(u - before.x, v - before.y) : nothing.data();
      const double p = (1 - opacity) * from[3];
      const double q = opacity * to[3];
      if (p + q <= 0) continue;
      for (int k = 0; k < 3; ++k)
        to[k] = static_cast<uint8_t>(std::lround((p * from[k] + q * to[k]) / (p + q)));
      to[3] = static_cast<uint8_t>(std::lround(p + q));
    }
}

/// Makes the layers and merged groups without a role texture, where some of them is a part. A group
/// in which something else is a part is not merged.
void settle_roles(LayerStack& stack) {
  bool some_part = false;
  const auto state_part = [&](int parent) {
    some_part = true;
    for (int g = parent; g != no_group; g = stack.groups[g].parent)
      if (stack.groups[g].role == LayerRole::part) stack.groups[g].merged = false;
  };
  for (const RasterLayer& layer : stack.layers)
    if (layer.role == LayerRole::part) state_part(layer.group);
  for (const LayerGroup& group : stack.groups)
    if (group.role == LayerRole::part && group.merged) state_part(group.parent);
  if (!some_part) return;
  for (RasterLayer& layer : stack.layers)
    if (layer.role == LayerRole::proposed) layer.role = LayerRole::texture;
  for (LayerGroup& group : stack.groups)
    if (group.role == LayerRole::proposed) group.role = LayerRole::texture;
}

/// The ways in which the layers of a group are laid on what lies below it.
enum class GroupWay {
  direct,    ///< one by one
  isolated,  ///< composed on a sheet of their own
  faded,     ///< one by one, but the change as a whole has an opacity
};

std::vector<GroupWay> ways_of(const LayerStack& stack) {
  std::vector<char> mixes(stack.groups.size(), 0);
  const auto mark = [&](int group) {
    for (int g = group; g != no_group; g = stack.groups[g].parent) mixes[g] = 1;
  };
  for (const RasterLayer& layer : stack.layers)
    if (!layer.blending.is_plain()) mark(layer.group);
  for (const LayerGroup& group : stack.groups)
    if (!group.blending.is_plain()) mark(group.parent);
  std::vector<GroupWay> ways;
  for (size_t g = 0; g < stack.groups.size(); ++g) {
    const LayerGroup& group = stack.groups[g];
    const bool dims = group.opacity < 1;
    const bool alone = group.merged || !group.blending.is_plain() ||
                       (!group.passes && (dims || mixes[g] != 0)) || (dims && mixes[g] == 0);
    ways.push_back(alone ? GroupWay::isolated : dims ? GroupWay::faded : GroupWay::direct);
  }
  return ways;
}

/// A group of which not all layers are laid yet.
struct OpenGroup {
  int number = no_group;
  RasterLayer sheet;  ///< of an isolated group; of a faded one, what lay below before
  size_t first_mark = 0;
  size_t first_part = 0;
};

class Composer {
 public:
  Composer(ImageSize canvas, const LayerStack& stack, const ImageLimits& limits)
      : canvas_(canvas), stack_(stack), limits_(limits), ways_(ways_of(stack)) {
    drawing_.scene.width = canvas.width;
    drawing_.scene.height = canvas.height;
    page_.rgba = Image8(canvas.width, canvas.height, 4);
  }

  Status put(RasterLayer layer) {
    if (Status status = go_to(layer.group); !status) return status;
    RasterLayer cut = cut_to_canvas(std::move(layer), canvas_.width, canvas_.height);
    if (Status status = lay_on_top(cut); !status) return status;
    cut_marks(cut);
    if (!cut.rgba.empty() && !is_merged(cut.group)) add(std::move(cut));
    return Done{};
  }

  Result<LayeredDrawing> finish() {
    if (Status status = go_to(no_group); !status) return status.error();
    drawing_.picture.rgba = std::move(page_.rgba);
    return std::move(drawing_);
  }

 private:
  const LayerGroup& group(int number) const { return stack_.groups[number]; }

  bool is_merged(int number) const {
    for (int g = number; g != no_group; g = group(g).parent)
      if (group(g).merged) return true;
    return false;
  }

  bool blends(const RasterLayer& layer) const {
    bool plain = layer.blending.is_plain();
    for (int g = layer.group; g != no_group; g = group(g).parent)
      plain &= group(g).blending.is_plain();
    return !plain;
  }

  /// Returns the sheet that is painted on.
  RasterLayer& top() {
    for (size_t k = open_.size(); k-- > 0;)
      if (ways_[open_[k].number] == GroupWay::isolated) return open_[k].sheet;
    return page_;
  }

  /// Adds a part or a mark for the layer, as it is seen through its groups.
  void add(RasterLayer layer) {
    if (layer.role == LayerRole::texture) return;
    const bool is_paint = blends(layer) && layer.role != LayerRole::part;
    for (int g = layer.group; g != no_group; g = group(g).parent) layer.opacity *= group(g).opacity;
    while (layer.group != no_group && group(layer.group).unnamed)
      layer.group = group(layer.group).parent;
    if (!is_paint) return add_layer(drawing_, layer);
    if (layer.blending.cover == CoverMode::over) add_ink(drawing_, std::move(layer));
  }

  Status lay_on_top(const RasterLayer& layer) {
    RasterLayer& sheet = top();
    lay(sheet, layer);
    int64_t held = 0;
    for (const OpenGroup& open : open_)
      held += int64_t{open.sheet.rgba.width} * open.sheet.rgba.height;
    if (held <= 2 * limits_.max_pixels) return Done{};
    return Error{ErrorCode::limit,
                 "has too many groups of layers in each other; merge some of them", ""};
  }

  /// Cuts the marks and parts below in the same group by what a layer erases.
  void cut_marks(const RasterLayer& layer) {
    const CoverMode cover = layer.blending.cover;
    if (cover != CoverMode::below_out && !erases_beside(cover)) return;
    const Region region = layer.rgba.empty() ? Region() : opaque_region(layer);
    const auto left_of = [&](const Region& old) {
      return cover == CoverMode::below_out ? subtract(old, region) : intersect(old, region);
    };
    size_t mark = 0;
    size_t part = 0;
    for (const OpenGroup& open : open_)
      if (ways_[open.number] == GroupWay::isolated) mark = open.first_mark, part = open.first_part;
    for (size_t k = mark; k < drawing_.marks.size(); ++k)
      drawing_.marks[k].region = left_of(drawing_.marks[k].region);
    for (size_t k = part; k < drawing_.scene.parts.size(); ++k)
      drawing_.scene.parts[k].outline = left_of(drawing_.scene.parts[k].outline);
  }

  /// Closes and opens groups so that the innermost open one is, or surrounds, this one.
  Status go_to(int number) {
    std::vector<int> path;
    for (int g = number; g != no_group; g = group(g).parent)
      if (ways_[g] != GroupWay::direct) path.insert(path.begin(), g);
    size_t common = 0;
    while (common < path.size() && common < open_.size() && open_[common].number == path[common])
      ++common;
    while (open_.size() > common)
      if (Status status = close(); !status) return status;
    for (size_t k = common; k < path.size(); ++k) {
      OpenGroup opened{path[k], {}, drawing_.marks.size(), drawing_.scene.parts.size()};
      if (ways_[path[k]] == GroupWay::faded) opened.sheet = top();
      open_.push_back(std::move(opened));
    }
    return Done{};
  }

  Status close() {
    OpenGroup closed = std::move(open_.back());
    open_.pop_back();
    const LayerGroup& own = group(closed.number);
    if (ways_[closed.number] == GroupWay::faded) {
      fade(top(), closed.sheet, own.opacity);
      return Done{};
    }
    RasterLayer sheet = std::move(closed.sheet);
    work_ += int64_t{sheet.rgba.width} * sheet.rgba.height;
    if (work_ > limits_.max_total)
      return Error{ErrorCode::limit, "has too many large groups of layers; merge some of them", ""};
    sheet.name = own.name;
    sheet.group = own.parent;
    sheet.role = own.role;
    sheet.opacity = own.opacity;
    sheet.blending = own.blending;
    if (Status status = lay_on_top(sheet); !status) return status;
    cut_marks(sheet);
    if (own.merged && !sheet.rgba.empty() && !is_merged(own.parent)) add(std::move(sheet));
    return Done{};
  }

  ImageSize canvas_;
  const LayerStack& stack_;
  const ImageLimits& limits_;
  std::vector<GroupWay> ways_;
  RasterLayer page_;  ///< the picture
  std::vector<OpenGroup> open_;
  int64_t work_ = 0;  ///< pixels of all sheets of groups so far
  LayeredDrawing drawing_;
};

/// Drops the marks and parts of which nothing is left.
void drop_erased(LayeredDrawing& drawing) {
  std::erase_if(drawing.marks, [](const auto& mark) { return mark.region.empty(); });
  for (size_t k = drawing.scene.parts.size(); k-- > 0;) {
    if (!drawing.scene.parts[k].outline.empty()) continue;
    const auto at = static_cast<std::ptrdiff_t>(k);
    drawing.scene.parts.erase(drawing.scene.parts.begin() + at);
    drawing.colors.erase(drawing.colors.begin() + at);
  }
}

}  // namespace

Result<LayeredDrawing> compose_layers(ImageSize canvas, LayerStack stack, const PixelsOf& pixels_of,
                                      const ImageLimits& limits) {
  settle_roles(stack);
  Composer composer(canvas, stack, limits);
  for (size_t k = 0; k < stack.layers.size(); ++k) {
    auto pixels = pixels_of(k);
    if (!pixels) return pixels.error();
    RasterLayer layer = stack.layers[k];
    layer.rgba = std::move(*pixels);
    if (Status status = composer.put(std::move(layer)); !status) return status.error();
  }
  auto drawing = composer.finish();
  if (!drawing) return drawing;
  drawing->flat = stack.layers.size() == 1 && drawing->scene.parts.empty();
  if (drawing->flat) drawing->warnings.clear();
  drop_erased(*drawing);
  return drawing;
}

}  // namespace relievo
