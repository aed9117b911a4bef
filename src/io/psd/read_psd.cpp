#include "io/psd/read_psd.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "io/layered/layer_files.h"
#include "io/psd/psd_file.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

/// As in PsdChannel.
constexpr int mask_channel = -2;
constexpr int alpha_channel = -1;

constexpr int no_group = -1;

/// The values that a group passes on to its layers.
struct Group {
  const PsdLayer* record = nullptr;
  int parent = no_group;
  double opacity = 1;
  bool hidden = false;
  LayerRole role = LayerRole::proposed;
};

/// A visible layer.
struct SeenLayer {
  RasterLayer layer;  ///< without its pixels
  const PsdLayer* record = nullptr;
  const PsdLayer* base = nullptr;  ///< the layer that it is clipped to, if any
};

struct Structure {
  std::vector<Group> groups;
  std::vector<SeenLayer> layers;  ///< back to front
  std::set<std::string> notes;
};

bool blends(const PsdLayer& record) {
  const std::string mode(record.blend.begin(), record.blend.end());
  return mode != "norm" && mode != "pass";
}

/// Finds the groups and returns the group of each record. A group's record lies in front of its
/// layers.
std::vector<int> find_groups(const PsdFile& file, std::vector<Group>& groups) {
  std::vector<int> group_of(file.layers.size(), no_group);
  int current = no_group;
  for (size_t k = file.layers.size(); k-- > 0;) {
    const PsdLayer& record = file.layers[k];
    group_of[k] = current;
    if (record.kind == PsdKind::group_end && current != no_group) current = groups[current].parent;
    if (record.kind != PsdKind::group) continue;
    const Group outer = current == no_group ? Group() : groups[current];
    groups.push_back({&record, current, outer.opacity * record.opacity,
                      outer.hidden || record.hidden, named_role(record.name, outer.role)});
    current = static_cast<int>(groups.size()) - 1;
  }
  return group_of;
}

std::string where_of(const PsdLayer& record) { return "layer \"" + record.name + "\""; }

void take_notes(const PsdLayer& record, std::set<std::string>& notes) {
  const std::string name = where_of(record) + ": ";
  if (blends(record)) notes.insert(name + "its blending mode is painted as normal");
  if (record.has_effects) notes.insert(name + "its effects are left out");
  if (record.has_vector_mask) notes.insert(name + "its vector mask is left out");
  if (record.adjusts && record.box.empty())
    notes.insert(name + "it adjusts or fills, and is left out");
}

RasterLayer raster_layer(const PsdLayer& record, int number, const Group& group) {
  RasterLayer layer;
  layer.role = record.clipped ? LayerRole::texture : named_role(record.name, group.role);
  layer.name = plain_layer_name(record.name, layer.role);
  layer.group = number;
  layer.x = record.box.left;
  layer.y = record.box.top;
  layer.opacity = group.opacity * record.opacity;
  return layer;
}

/// Finds the visible layers, with a note on everything that is painted differently.
Structure find_layers(const PsdFile& file) {
  Structure found;
  const std::vector<int> group_of = find_groups(file, found.groups);
  const PsdLayer* base = nullptr;  // of the layers that are clipped next
  bool base_hidden = false;
  for (size_t k = 0; k < file.layers.size(); ++k) {
    const PsdLayer& record = file.layers[k];
    const Group group = group_of[k] == no_group ? Group() : found.groups[group_of[k]];
    const bool hidden = group.hidden || record.hidden;
    if (!record.clipped || record.kind != PsdKind::layer) {
      base = record.kind == PsdKind::layer ? &record : nullptr;
      base_hidden = hidden && record.kind != PsdKind::group_end;
    }
    if (hidden || record.kind == PsdKind::group_end || (record.clipped && base_hidden)) continue;
    take_notes(record, found.notes);
    if (record.clipped && base == nullptr)
      found.notes.insert(where_of(record) + ": it is clipped to a group, and is not cut");
    if (record.kind == PsdKind::layer && !record.box.empty())
      found.layers.push_back(
          {raster_layer(record, group_of[k], group), &record, record.clipped ? base : nullptr});
  }
  return found;
}

const PsdChannel* channel(const PsdLayer& record, int id) {
  const auto found = std::find_if(record.channels.begin(), record.channels.end(),
                                  [id](const PsdChannel& one) { return one.id == id; });
  return found == record.channels.end() ? nullptr : &*found;
}

/// Returns the plane of a channel over a box, or `value` everywhere for a missing one. It is empty
/// for a box without pixels, whose sides may be negative.
Result<std::vector<uint8_t>> plane(const PsdLayer& record, int id, const PsdBox& box, int depth,
                                   uint8_t value) {
  if (box.empty()) return std::vector<uint8_t>();
  const PsdChannel* packed = channel(record, id);
  if (packed == nullptr) return std::vector<uint8_t>(size_t(box.width()) * box.height(), value);
  return decode_channel(packed->data, box.width(), box.height(), depth);
}

/// Multiplies values over `box` with others over another box, which are `outside` beyond it.
void multiply(const PsdBox& box, std::vector<uint8_t>& alpha, const PsdBox& other,
              const std::vector<uint8_t>& values, uint8_t outside) {
  size_t at = 0;
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x, ++at) {
      const bool inside = x >= other.left && x < other.right && y >= other.top && y < other.bottom;
      const size_t there = size_t(y - other.top) * other.width() + (x - other.left);
      const int value = inside ? values[there] : outside;
      alpha[at] = static_cast<uint8_t>((alpha[at] * value + 127) / 255);
    }
}

/// Applies the mask of `masked`, a layer or a group, to values over `box`.
Status apply_mask(const PsdLayer& masked, int depth, const PsdBox& box,
                  std::vector<uint8_t>& alpha) {
  if (!masked.mask || masked.mask->disabled) return Done{};
  const PsdBox& other = masked.mask->box;
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

/// Returns the alpha of a layer, times its own mask.
Result<std::vector<uint8_t>> alpha_of(const PsdLayer& record, int depth) {
  auto alpha = plane(record, alpha_channel, record.box, depth, 255);
  if (!alpha) return alpha.error();
  if (Status status = apply_mask(record, depth, record.box, *alpha); !status) return status.error();
  return alpha;
}

/// Returns the alpha of a layer, times all masks and the layer that it is clipped to.
Result<std::vector<uint8_t>> seen_alpha(const SeenLayer& seen, const std::vector<Group>& groups,
                                        int depth) {
  const PsdBox& box = seen.record->box;
  auto alpha = alpha_of(*seen.record, depth);
  if (!alpha) return alpha.error();
  for (int g = seen.layer.group; g != no_group; g = groups[g].parent)
    if (Status s = apply_mask(*groups[g].record, depth, box, *alpha); !s) return s.error();
  if (seen.base == nullptr) return alpha;
  auto base = alpha_of(*seen.base, depth);
  if (!base) return base.error();
  for (uint8_t& value : *base)
    value = static_cast<uint8_t>(std::lround(value * seen.base->opacity));
  multiply(box, *alpha, seen.base->box, *base, 0);
  return alpha;
}

Result<Image8> pixels_of(const SeenLayer& seen, const Structure& structure, const PsdFile& file) {
  const PsdBox& box = seen.record->box;
  Image8 rgba(box.width(), box.height(), 4);
  for (int k = 0; k < 4; ++k) {
    const auto values = k == 3
                            ? seen_alpha(seen, structure.groups, file.depth)
                            : plane(*seen.record, std::min(k, file.colors - 1), box, file.depth, 0);
    if (!values) return values.error();
    for (size_t i = 0; i < values->size(); ++i) rgba.pixels[4 * i + k] = (*values)[i];
  }
  return rgba;
}

/// Checks the pixels of all layers and of those that they are clipped to, to which the time of
/// reading is proportional.
Status check_total(const std::vector<SeenLayer>& layers, const ImageLimits& limits) {
  int64_t total = 0;
  for (const SeenLayer& seen : layers)
    for (const PsdLayer* record : {seen.record, seen.base}) {
      if (record == nullptr) continue;
      const Status added = add_layer_pixels(record->box.width(), record->box.height(), limits,
                                            where_of(*record), total);
      if (!added) return added;
    }
  return Done{};
}

Status paint_merged(const PsdFile& file, Image8& rgba) {
  const auto planes =
      decode_merged(file.merged, file.channels, file.width, file.height, file.depth);
  if (!planes) return planes.error();
  for (size_t i = 0; i < (*planes)[0].size(); ++i) {
    for (int k = 0; k < 3; ++k) rgba.pixels[4 * i + k] = (*planes)[std::min(k, file.colors - 1)][i];
    rgba.pixels[4 * i + 3] = 255;
  }
  return Done{};
}

}  // namespace

Result<understanding::LayeredDrawing> read_psd(ByteView bytes, const ImageLimits& limits) {
  const auto file = read_psd_file(bytes, limits);
  if (!file) return file.error();
  understanding::LayeredDrawing drawing = empty_drawing(file->width, file->height);
  if (file->layers.empty()) {
    if (Status status = paint_merged(*file, drawing.picture.rgba); !status) return status.error();
    drawing.flat = true;
    return drawing;
  }
  Structure structure = find_layers(*file);
  if (structure.layers.empty())
    return Error{ErrorCode::bad_input, "shows no layer with pixels; make a layer visible",
                 "layers"};
  if (Status status = check_total(structure.layers, limits); !status) return status.error();
  settle_roles(structure.layers);
  for (SeenLayer& seen : structure.layers) {
    auto pixels = pixels_of(seen, structure, *file);
    if (!pixels) return Error{pixels.error().code, pixels.error().message, where_of(*seen.record)};
    RasterLayer layer = seen.layer;
    layer.rgba = std::move(*pixels);
    put_layer(drawing, layer);
  }
  drawing.flat = structure.layers.size() == 1;
  if (drawing.flat) drawing.warnings.clear();
  drawing.warnings.insert(drawing.warnings.end(), structure.notes.begin(), structure.notes.end());
  return drawing;
}

}  // namespace relievo
