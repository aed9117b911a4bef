#include "io/layered/read_ora.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>
#include <utility>

#include "io/image/png.h"
#include "io/layered/compose_layers.h"
#include "io/layered/layer_files.h"
#include "io/layered/layer_names.h"
#include "io/layered/merged_picture.h"
#include "kernel/base/text_rules.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

constexpr const char* stack_name = "stack.xml";
constexpr int max_depth = 64;                ///< of nested groups of layers
constexpr size_t max_stack_bytes = 4 << 20;  ///< of stack.xml

Error stack_error(const std::string& message) {
  return {ErrorCode::bad_input, message, stack_name};
}

double opacity_of(const pugi::xml_node& node) {
  const double opacity = node.attribute("opacity").as_double(1);
  return std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1;
}

/// Walks the stack, topmost layer first, and collects the groups and the visible layers.
class StackReader {
 public:
  StackReader(const std::vector<ArchiveEntry>& entries, const PaintSvg& paint_svg)
      : entries_(entries), paint_svg_(paint_svg) {}

  /// Reads what is in a group.
  Status read(const pugi::xml_node& stack, int group, LayerRole role, int depth) {
    if (depth > max_depth)
      return Error{ErrorCode::limit, "has groups of layers nested too deeply", stack_name};
    for (const pugi::xml_node& node : stack.children()) {
      const bool is_group = std::strcmp(node.name(), "stack") == 0;
      if (!is_group && std::strcmp(node.name(), "layer") != 0) continue;
      if (std::strcmp(node.attribute("visibility").value(), "hidden") == 0) continue;
      const LayerName name = read_layer_name(node.attribute("name").value(), role);
      if (name.ignored) continue;
      const Status status = is_group ? add_group(node, name, group, depth) : add(node, name, group);
      if (!status) return status.error();
    }
    return Done{};
  }

  /// Returns the layers, back to front.
  std::vector<LayerFile> take_layers() {
    std::reverse(layers_.begin(), layers_.end());
    return std::move(layers_);
  }

  std::vector<LayerGroup> take_groups() { return std::move(groups_); }
  std::vector<std::string> take_warnings() { return std::move(warnings_); }
  bool is_incomplete() const { return incomplete_; }

 private:
  Blending blending_of(const pugi::xml_node& node) {
    const std::string stated = node.attribute("composite-op").as_string("svg:src-over");
    const auto known = named_blending(stated);
    if (!known)
      warnings_.push_back("layer \"" + std::string(node.attribute("name").value()) +
                          "\": its blending mode " + stated + " is painted as normal");
    return known.value_or(Blending());
  }

  Status add_group(const pugi::xml_node& node, const LayerName& name, int parent, int depth) {
    LayerGroup group;
    group.name = name.plain;
    group.parent = parent;
    group.opacity = opacity_of(node);
    group.blending = blending_of(node);
    group.passes = std::strcmp(node.attribute("isolation").value(), "auto") == 0 &&
                   group.opacity == 1 && group.blending.is_plain();
    group.role = name.role;
    group.merged = name.merged;
    groups_.push_back(std::move(group));
    return read(node, static_cast<int>(groups_.size()) - 1, name.role, depth + 1);
  }

  Status add(const pugi::xml_node& node, const LayerName& name, int group) {
    if (layers_.size() == max_layers)
      return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers",
                   stack_name};
    const std::string file = node.attribute("src").value();
    const ArchiveEntry* entry = find_entry(entries_, file);
    if (entry == nullptr) return stack_error("names a picture that is not in the archive: " + file);
    RasterLayer layer;
    layer.name = name.plain;
    layer.group = group;
    layer.x = std::clamp(node.attribute("x").as_int(), -1'000'000, 1'000'000);
    layer.y = std::clamp(node.attribute("y").as_int(), -1'000'000, 1'000'000);
    layer.opacity = opacity_of(node);
    layer.role = name.role;
    layer.blending = blending_of(node);
    const bool vector = lower_case(file).ends_with(".svg");
    if (vector && !paint_svg_) {
      incomplete_ = true;
      warnings_.push_back("layer \"" + layer.name + "\": it is a vector drawing, and is left out");
      return Done{};
    }
    auto png = vector ? painted(*entry) : Result<Bytes>(entry->bytes);
    if (!png) return Error{png.error().code, png.error().message, file};
    layers_.push_back({std::move(layer), file, 0, std::move(*png)});
    return Done{};
  }

  Result<Bytes> painted(const ArchiveEntry& svg) const {
    const auto picture = paint_svg_(svg.bytes);
    if (!picture) return picture.error();
    return encode_png(*picture);
  }

  const std::vector<ArchiveEntry>& entries_;
  const PaintSvg& paint_svg_;
  std::vector<LayerGroup> groups_;
  std::vector<LayerFile> layers_;
  std::vector<std::string> warnings_;
  bool incomplete_ = false;  ///< a vector layer is missing
};

/// Takes the merged picture if there is one that shows something.
void try_merged(const std::vector<ArchiveEntry>& entries, const ImageLimits& limits,
                const std::string& reason, understanding::LayeredDrawing& drawing) {
  const ArchiveEntry* entry = find_entry(entries, "mergedimage.png");
  if (entry == nullptr) return;
  auto merged = decode_png(entry->bytes, limits);
  if (merged && !is_blank(*merged)) take_merged(drawing, std::move(*merged), reason);
}

}  // namespace

bool is_ora(const std::vector<ArchiveEntry>& entries) {
  const ArchiveEntry* type = find_entry(entries, "mimetype");
  const std::string said =
      type == nullptr ? "" : std::string(type->bytes.begin(), type->bytes.end());
  return said.rfind("image/openraster", 0) == 0;
}

Result<understanding::LayeredDrawing> read_ora(const std::vector<ArchiveEntry>& entries,
                                               const ImageLimits& limits,
                                               const PaintSvg& paint_svg) {
  const ArchiveEntry* stack = find_entry(entries, stack_name);
  if (stack == nullptr) return Error{ErrorCode::bad_input, "has no stack.xml", ""};
  if (stack->bytes.size() > max_stack_bytes)
    return Error{ErrorCode::limit, "is too large", stack_name};
  pugi::xml_document xml;
  const auto parsed = xml.load_buffer(stack->bytes.data(), stack->bytes.size());
  if (!parsed) return stack_error(std::string("is not XML: ") + parsed.description());
  const pugi::xml_node image = xml.child("image");
  const ImageSize canvas{image.attribute("w").as_int(), image.attribute("h").as_int()};
  if (const Status size = check_image_size(canvas.width, canvas.height, limits); !size)
    return Error{size.error().code, size.error().message, stack_name};
  StackReader reader(entries, paint_svg);
  if (Status s = reader.read(image.child("stack"), -1, LayerRole::proposed, 0); !s)
    return s.error();
  auto drawing = unpack_layers(reader.take_layers(), reader.take_groups(), canvas, limits);
  if (!drawing) return drawing;
  for (std::string& warning : reader.take_warnings())
    drawing->warnings.push_back(std::move(warning));
  if (reader.is_incomplete())
    try_merged(entries, limits, "a layer is a vector drawing, which is not painted here", *drawing);
  else if (drawing->marks.empty() && drawing->scene.parts.empty())
    try_merged(entries, limits, "no layer shows anything opaque", *drawing);
  return drawing;
}

}  // namespace relievo
