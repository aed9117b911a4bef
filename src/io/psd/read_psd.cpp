#include "io/psd/read_psd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "io/layered/compose_layers.h"
#include "io/layered/layer_names.h"
#include "io/layered/merged_picture.h"
#include "io/psd/psd_file.h"
#include "io/psd/psd_fill.h"
#include "kernel/geometry/polygon.h"
#include "kernel/image/compose.h"

namespace relievo {
namespace {

/// As in PsdChannel.
constexpr int mask_channel = -2;
constexpr int alpha_channel = -1;

constexpr int no_group = -1;

/// A visible layer.
struct SeenLayer {
  const PsdLayer* record = nullptr;
  PixelBox box;                                ///< of its pixels, or of the fill in its masks
  std::optional<std::array<uint8_t, 3>> fill;  ///< its one colour, where it has no pixels
  std::optional<Region> vector;                ///< the area of its vector mask, if that cuts it
};

struct Structure {
  LayerStack stack;                     ///< its layers without their pixels
  std::vector<SeenLayer> layers;        ///< those of the stack
  std::vector<const PsdLayer*> groups;  ///< of the stack; null where they are none of the file's
  std::set<std::string> notes;          ///< on what is painted differently
  bool is_sure = true;                  ///< all is painted as it was drawn
};

std::string where_of(const PsdLayer& record) { return "layer \"" + record.name + "\""; }

/// Returns the records in each group, from back to front, by the number of the group's record;
/// those in no group are in the last list. A group's record lies in front of its layers.
std::vector<std::vector<size_t>> children_of(const PsdFile& file) {
  std::vector<std::vector<size_t>> children(file.layers.size() + 1);
  std::vector<size_t> open = {file.layers.size()};
  for (size_t k = file.layers.size(); k-- > 0;) {
    const PsdKind kind = file.layers[k].kind;
    if (kind == PsdKind::group_end) {
      if (open.size() > 1) open.pop_back();
      continue;
    }
    children[open.back()].push_back(k);
    if (kind == PsdKind::group) open.push_back(k);
  }
  for (std::vector<size_t>& list : children) std::reverse(list.begin(), list.end());
  return children;
}

/// Returns the box of a fill in its masks, on the canvas.
PixelBox fill_box(const PsdLayer& record, const std::optional<Region>& vector,
                  const PsdFile& file) {
  PixelBox box = {0, 0, file.width, file.height};
  if (record.mask && !record.mask->disabled && record.mask->outside == 0)
    box = intersect(box, record.mask->box);
  if (!vector) return box;
  const Box2 area = bounding_box(*vector);
  if (vector->empty()) return {};
  return intersect(
      box, {static_cast<int>(std::floor(area.min.x)), static_cast<int>(std::floor(area.min.y)),
            static_cast<int>(std::ceil(area.max.x)), static_cast<int>(std::ceil(area.max.y))});
}

/// Finds the groups and the visible layers, with a note on everything that is painted differently.
class StructureReader {
 public:
  explicit StructureReader(const PsdFile& file) : file_(file), children_(children_of(file)) {}

  Structure run() {
    read(file_.layers.size(), no_group, LayerRole::proposed);
    return std::move(found_);
  }

 private:
  /// Reads what is in the group of this record.
  void read(size_t record, int group, LayerRole role) {
    const std::vector<size_t>& list = children_[record];
    int base = group;  // of what is clipped next
    bool base_hidden = false;
    for (size_t i = 0; i < list.size(); ++i) {
      const PsdLayer& child = file_.layers[list[i]];
      const LayerName name = read_layer_name(child.name, role);
      const bool hidden = child.hidden || name.ignored;
      const bool clipped = child.clipped && i > 0;
      if (!clipped) base_hidden = hidden;
      if (hidden || base_hidden) continue;
      take_notes(child);
      const bool is_base = i + 1 < list.size() && file_.layers[list[i + 1]].clipped;
      if (clipped)
        add(list[i], {name.plain, LayerRole::texture}, base, CoverMode::atop, false);
      else
        base = add(list[i], name, group, CoverMode::over, is_base);
    }
  }

  /// Adds a layer, or a group with its layers. Returns the group that takes what is clipped to it.
  int add(size_t number, const LayerName& name, int parent, CoverMode cover, bool is_base) {
    const PsdLayer& record = file_.layers[number];
    if (record.kind == PsdKind::group) {
      const int group = add_group(record, name, parent, cover);
      if (is_base) found_.stack.groups[group].passes = false;
      read(number, group, name.role);
      return group;
    }
    if (!is_base) {
      add_layer_of(record, name, parent, {mode_of(record), cover}, record.opacity);
      return parent;
    }
    LayerName none;
    none.role = name.role;
    const int group = add_group(record, none, parent, cover);
    found_.groups[group] = nullptr;
    found_.stack.groups[group].unnamed = true;
    add_layer_of(record, name, group, {}, 1);
    return group;
  }

  int add_group(const PsdLayer& record, const LayerName& name, int parent, CoverMode cover) {
    LayerGroup group;
    group.name = name.plain;
    group.parent = parent;
    group.opacity = record.opacity;
    group.blending = {mode_of(record), cover};
    group.passes = record.blend == std::array{'p', 'a', 's', 's'} && cover == CoverMode::over;
    group.role = name.role;
    group.merged = name.merged;
    found_.stack.groups.push_back(std::move(group));
    found_.groups.push_back(&record);
    return static_cast<int>(found_.groups.size()) - 1;
  }

  void add_layer_of(const PsdLayer& record, const LayerName& name, int group, Blending blending,
                    double opacity) {
    SeenLayer seen{&record, record.box, std::nullopt, std::nullopt};
    const bool rendered = record.mask && record.mask->rendered;
    const bool is_fill = record.adjusts;
    if (!record.vector_mask.empty() && !rendered && !(is_fill && !record.box.empty()))
      seen.vector = vector_mask(record.vector_mask, file_.width, file_.height);
    if (record.box.empty() && !record.solid_fill.empty()) {
      seen.fill = fill_color(record.solid_fill);
      if (seen.fill) seen.box = fill_box(record, seen.vector, file_);
    }
    found_.is_sure &= !seen.vector && !seen.fill;
    if (seen.box.empty()) return;
    RasterLayer layer;
    layer.name = name.plain;
    layer.role = name.role;
    layer.group = group;
    layer.x = seen.box.left;
    layer.y = seen.box.top;
    layer.opacity = opacity;
    layer.blending = blending;
    found_.stack.layers.push_back(std::move(layer));
    found_.layers.push_back(std::move(seen));
  }

  static BlendMode mode_of(const PsdLayer& record) {
    return keyed_mode(record.blend).value_or(BlendMode::normal);
  }

  void take_notes(const PsdLayer& record) {
    const std::string name = where_of(record) + ": ";
    std::set<std::string> notes;
    if (!keyed_mode(record.blend)) notes.insert(name + "its blending mode is painted as normal");
    if (record.has_effects) notes.insert(name + "its effects are left out");
    const bool painted = !record.solid_fill.empty() && fill_color(record.solid_fill);
    if (record.adjusts && record.box.empty() && !painted)
      notes.insert(name + "it adjusts or fills, and is left out");
    found_.is_sure &= notes.empty();
    if (record.is_artboard) notes.insert(name + "the ground of an artboard is left out");
    found_.notes.merge(notes);
  }

  const PsdFile& file_;
  std::vector<std::vector<size_t>> children_;
  Structure found_;
};

const PsdChannel* channel(const PsdLayer& record, int id) {
  const auto found = std::find_if(record.channels.begin(), record.channels.end(),
                                  [id](const PsdChannel& one) { return one.id == id; });
  return found == record.channels.end() ? nullptr : &*found;
}

/// Returns the plane of a channel over a box, or `value` everywhere for a missing one. It is empty
/// for a box without pixels, whose sides may be negative.
Result<std::vector<uint8_t>> plane(const PsdLayer& record, int id, const PixelBox& box, int depth,
                                   uint8_t value) {
  if (box.empty()) return std::vector<uint8_t>();
  const PsdChannel* packed = channel(record, id);
  if (packed == nullptr) return std::vector<uint8_t>(size_t(box.width()) * box.height(), value);
  return decode_channel(packed->data, box.width(), box.height(), depth);
}

/// Multiplies values over `box` with others over another box, which are `outside` beyond it.
void multiply(const PixelBox& box, std::vector<uint8_t>& alpha, const PixelBox& other,
              const std::vector<uint8_t>& values, uint8_t outside) {
  size_t at = 0;
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x, ++at) {
      const size_t there = size_t(y - other.top) * other.width() + (x - other.left);
      const int value = other.contains(x, y) ? values[there] : outside;
      alpha[at] = static_cast<uint8_t>((alpha[at] * value + 127) / 255);
    }
}

/// Applies the mask of `masked`, a layer or a group, to values over `box`.
Status apply_mask(const PsdLayer& masked, int depth, const PixelBox& box,
                  std::vector<uint8_t>& alpha) {
  if (!masked.mask || masked.mask->disabled) return Done{};
  const PixelBox& other = masked.mask->box;
  if (other.empty()) {
    multiply(box, alpha, other, {}, masked.mask->outside);
    return Done{};
  }
  if (channel(masked, mask_channel) == nullptr) return Done{};
  const auto values = plane(masked, mask_channel, other, depth, 255);
  if (!values) return values.error();
  multiply(box, alpha, other, *values, masked.mask->outside);
  return Done{};
}

/// Returns the alpha of a layer, times all masks of it and its groups.
Result<std::vector<uint8_t>> seen_alpha(const SeenLayer& seen, int group, const Structure& found,
                                        int depth) {
  const PixelBox& box = seen.box;
  auto alpha = seen.fill ? std::vector<uint8_t>(size_t(box.width()) * box.height(), 255)
                         : plane(*seen.record, alpha_channel, box, depth, 255);
  if (!alpha) return alpha.error();
  if (seen.vector) multiply(box, *alpha, box, coverage(*seen.vector, box), 0);
  if (Status s = apply_mask(*seen.record, depth, box, *alpha); !s) return s.error();
  for (int g = group; g != no_group; g = found.stack.groups[g].parent)
    if (found.groups[g] != nullptr)
      if (Status s = apply_mask(*found.groups[g], depth, box, *alpha); !s) return s.error();
  return alpha;
}

Result<Image8> pixels_of(size_t number, const Structure& found, const PsdFile& file) {
  const SeenLayer& seen = found.layers[number];
  const PixelBox& box = seen.box;
  Image8 rgba(box.width(), box.height(), 4);
  const auto channel_of = [&](int k) -> Result<std::vector<uint8_t>> {
    if (k == 3) return seen_alpha(seen, found.stack.layers[number].group, found, file.depth);
    if (seen.fill) return std::vector<uint8_t>(rgba.pixels.size() / 4, (*seen.fill)[k]);
    return plane(*seen.record, std::min(k, file.colors - 1), box, file.depth, 0);
  };
  for (int k = 0; k < 4; ++k) {
    const auto values = channel_of(k);
    if (!values) return values.error();
    for (size_t i = 0; i < values->size(); ++i) rgba.pixels[4 * i + k] = (*values)[i];
  }
  return rgba;
}

/// Checks the pixels of all layers, to which the time of reading is proportional.
Status check_total(const std::vector<SeenLayer>& layers, const ImageLimits& limits) {
  int64_t total = 0;
  for (const SeenLayer& seen : layers) {
    const Status added = add_layer_pixels(seen.box.width(), seen.box.height(), limits,
                                          where_of(*seen.record), total);
    if (!added) return added;
  }
  return Done{};
}

/// Decodes the flattened picture. Where it has transparency, its colours lie on white.
Result<Image8> merged_picture(const PsdFile& file) {
  const auto planes =
      decode_merged(file.merged, file.channels, file.width, file.height, file.depth);
  if (!planes) return planes.error();
  Image8 rgba(file.width, file.height, 4);
  for (size_t i = 0; i < (*planes)[0].size(); ++i) {
    const double alpha = file.merged_alpha ? (*planes)[file.colors][i] / 255.0 : 1;
    for (int k = 0; k < 3; ++k) {
      const double on_white = (*planes)[std::min(k, file.colors - 1)][i];
      rgba.pixels[4 * i + k] = alpha > 0 ? off_paper(on_white, alpha) : uint8_t{0};
    }
    rgba.pixels[4 * i + 3] = static_cast<uint8_t>(std::lround(255 * alpha));
  }
  return rgba;
}

/// Returns the flattened picture if it shows something.
std::optional<Image8> shown_picture(const PsdFile& file) {
  if (!file.has_merged) return std::nullopt;
  auto merged = merged_picture(file);
  if (!merged || is_blank(*merged)) return std::nullopt;
  return std::move(*merged);
}

understanding::LayeredDrawing empty_drawing(const PsdFile& file) {
  understanding::LayeredDrawing drawing;
  drawing.scene.width = file.width;
  drawing.scene.height = file.height;
  return drawing;
}

/// Takes the flattened picture where the layers do not give the drawing. Returns whether it was
/// taken.
bool settle_picture(const PsdFile& file, bool is_sure, understanding::LayeredDrawing& drawing) {
  const bool nothing = drawing.marks.empty() && drawing.scene.parts.empty();
  if (is_sure && !nothing) return false;
  auto merged = shown_picture(file);
  if (!merged) return false;
  if (!nothing) return compare_with_merged(drawing, std::move(*merged));
  take_merged(drawing, std::move(*merged), "no layer shows anything opaque");
  return true;
}

}  // namespace

Result<understanding::LayeredDrawing> read_psd(ByteView bytes, const ImageLimits& limits) {
  const auto file = read_psd_file(bytes, limits);
  if (!file) return file.error();
  if (file->layers.empty()) {
    auto merged = merged_picture(*file);
    if (!merged) return merged.error();
    understanding::LayeredDrawing drawing = empty_drawing(*file);
    drawing.picture.rgba = std::move(*merged);
    drawing.flat = true;
    return drawing;
  }
  Structure found = StructureReader(*file).run();
  if (found.layers.empty()) {
    auto merged = shown_picture(*file);
    if (!merged)
      return Error{ErrorCode::bad_input, "shows no layer with pixels; make a layer visible",
                   "layers"};
    understanding::LayeredDrawing drawing = empty_drawing(*file);
    take_merged(drawing, std::move(*merged), "no layer has pixels");
    return drawing;
  }
  if (Status status = check_total(found.layers, limits); !status) return status.error();
  const auto pixels = [&](size_t k) -> Result<Image8> {
    auto rgba = pixels_of(k, found, *file);
    if (!rgba)
      return Error{rgba.error().code, rgba.error().message, where_of(*found.layers[k].record)};
    return rgba;
  };
  auto drawing = compose_layers({file->width, file->height}, found.stack, pixels, limits);
  if (!drawing || settle_picture(*file, found.is_sure, *drawing)) return drawing;
  drawing->warnings.insert(drawing->warnings.end(), found.notes.begin(), found.notes.end());
  return drawing;
}

}  // namespace relievo
