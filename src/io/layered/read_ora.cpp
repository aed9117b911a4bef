#include "io/layered/read_ora.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>
#include <utility>

#include "io/layered/layer_files.h"
#include "kernel/image/image_size.h"

namespace relievo {
namespace {

constexpr const char* stack_name = "stack.xml";
constexpr int max_depth = 64;                ///< of nested groups of layers
constexpr size_t max_stack_bytes = 4 << 20;  ///< of stack.xml

Error stack_error(const std::string& message) {
  return {ErrorCode::bad_input, message, stack_name};
}

/// The values that a group of layers passes on to its layers.
struct Group {
  int number = -1;
  double opacity = 1;
  LayerRole role = LayerRole::proposed;
};

/// Walks the stack, topmost layer first, and collects the visible layers.
class StackReader {
 public:
  explicit StackReader(const std::vector<ArchiveEntry>& entries) : entries_(entries) {}

  Status read(const pugi::xml_node& stack, const Group& group, int depth) {
    if (depth > max_depth)
      return Error{ErrorCode::limit, "has groups of layers nested too deeply", stack_name};
    for (const pugi::xml_node& node : stack.children()) {
      const bool is_group = std::strcmp(node.name(), "stack") == 0;
      if (!is_group && std::strcmp(node.name(), "layer") != 0) continue;
      if (std::strcmp(node.attribute("visibility").value(), "hidden") == 0) continue;
      const Group own = inherit(node, group, is_group);
      const Status status = is_group ? read(node, own, depth + 1) : add(node, own);
      if (!status) return status.error();
    }
    return Done{};
  }

  /// Returns the layers, back to front.
  std::vector<LayerFile> take_layers() {
    std::reverse(layers_.begin(), layers_.end());
    return std::move(layers_);
  }

  bool blends() const { return blends_; }

 private:
  Group inherit(const pugi::xml_node& node, const Group& group, bool is_group) {
    const std::string blending = node.attribute("composite-op").as_string("svg:src-over");
    blends_ |= blending != "svg:src-over";
    Group own = group;
    if (is_group) own.number = groups_++;
    const double opacity = node.attribute("opacity").as_double(1);
    own.opacity *= std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1;
    own.role = named_role(node.attribute("name").value(), own.role);
    return own;
  }

  Status add(const pugi::xml_node& node, const Group& group) {
    if (layers_.size() == max_layers)
      return Error{ErrorCode::limit, "has more than " + std::to_string(max_layers) + " layers",
                   stack_name};
    const std::string file = node.attribute("src").value();
    const ArchiveEntry* entry = find_entry(entries_, file);
    if (entry == nullptr) return stack_error("names a picture that is not in the archive: " + file);
    RasterLayer layer;
    layer.name = plain_layer_name(node.attribute("name").value(), group.role);
    layer.group = group.number;
    layer.x = std::clamp(node.attribute("x").as_int(), -1'000'000, 1'000'000);
    layer.y = std::clamp(node.attribute("y").as_int(), -1'000'000, 1'000'000);
    layer.opacity = group.opacity;
    layer.role = group.role;
    layers_.push_back({std::move(layer), file, 0, entry->bytes});
    return Done{};
  }

  const std::vector<ArchiveEntry>& entries_;
  std::vector<LayerFile> layers_;
  int groups_ = 0;
  bool blends_ = false;
};

}  // namespace

bool is_ora(const std::vector<ArchiveEntry>& entries) {
  const ArchiveEntry* type = find_entry(entries, "mimetype");
  const std::string said =
      type == nullptr ? "" : std::string(type->bytes.begin(), type->bytes.end());
  return said.rfind("image/openraster", 0) == 0;
}

Result<understanding::LayeredDrawing> read_ora(const std::vector<ArchiveEntry>& entries,
                                               const ImageLimits& limits) {
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
  StackReader reader(entries);
  if (Status s = reader.read(image.child("stack"), Group(), 0); !s) return s.error();
  std::vector<LayerFile> layers = reader.take_layers();
  settle_roles(layers);
  auto drawing = unpack_layers(layers, canvas, limits);
  if (drawing && reader.blends())
    drawing->warnings.emplace_back("layers with a blending mode are painted as normal layers");
  return drawing;
}

}  // namespace relievo
