#include "io/mesh/glb_decode.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "io/image/decode_image.h"
#include "io/mesh/placement.h"
#include "relievo/scene.h"

namespace relievo {
namespace {

using Json = nlohmann::json;

constexpr int max_json_depth = 64;
constexpr double default_canvas = 1000;
constexpr double max_extent = 1e9;  ///< largest coordinate of a model, px

/// Throws an error, which decode_glb catches and returns.
[[noreturn]] void refuse(const std::string& message, const std::string& where = "") {
  throw Error{ErrorCode::bad_input, "is not a model that can be read: " + message, where};
}

uint32_t read_u32(const uint8_t* at) {
  return uint32_t{at[0]} | uint32_t{at[1]} << 8 | uint32_t{at[2]} << 16 | uint32_t{at[3]} << 24;
}

uint16_t read_u16(const uint8_t* at) { return static_cast<uint16_t>(at[0] | at[1] << 8); }

double read_f32(const uint8_t* at) {
  const uint32_t bits = read_u32(at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

const Json& member(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) refuse("a key is missing", key);
  return *found;
}

size_t natural(const Json& value, const char* key) {
  if (!value.is_number_unsigned() || value.get<uint64_t>() > UINT32_MAX)
    refuse("not a natural number", key);
  return value.get<size_t>();
}

size_t natural_member(const Json& object, const char* key,
                      std::optional<size_t> fallback = std::nullopt) {
  if (fallback && !object.contains(key)) return *fallback;
  return natural(member(object, key), key);
}

double number(const Json& value, const char* key) {
  if (!value.is_number()) refuse("not a number", key);
  return value.get<double>();
}

Point2 pair(const Json& value, const char* key) {
  if (!value.is_array() || value.size() != 2) refuse("not two numbers", key);
  return {number(value[0], key), number(value[1], key)};
}

const Json& element(const Json& object, const char* key, size_t index) {
  const Json& list = member(object, key);
  if (!list.is_array() || index >= list.size()) refuse("an index is out of range", key);
  return list[index];
}

/// The file's two chunks.
struct Glb {
  Json json;
  ByteView binary;
};

/// A list of vectors or numbers in the binary chunk, inside its bounds.
struct Accessor {
  const uint8_t* data = nullptr;
  size_t count = 0;
  size_t stride = 0;
  size_t component_type = 0;

  const uint8_t* at(size_t i) const { return data + i * stride; }
};

ByteView view_bytes(const Glb& glb, const Json& view) {
  const size_t offset = natural_member(view, "byteOffset", 0);
  const size_t length = natural_member(view, "byteLength");
  if (natural_member(view, "buffer") != 0 || offset > glb.binary.size() ||
      length > glb.binary.size() - offset)
    refuse("a view lies outside of the data", "bufferViews");
  return glb.binary.subspan(offset, length);
}

size_t component_size(size_t component_type) {
  if (component_type == component_u16) return 2;
  if (component_type != component_u32 && component_type != component_f32)
    refuse("this type of component is not supported", "accessors");
  return 4;
}

Accessor accessor_at(const Glb& glb, size_t index, const std::string& type, size_t components) {
  const Json& json = element(glb.json, "accessors", index);
  if (json.contains("sparse") || member(json, "type") != type)
    refuse("this type of accessor is not supported", "accessors");
  const Json& view = element(glb.json, "bufferViews", natural_member(json, "bufferView"));
  const ByteView bytes = view_bytes(glb, view);
  Accessor accessor;
  accessor.component_type = natural_member(json, "componentType");
  accessor.count = natural_member(json, "count");
  const size_t size = components * component_size(accessor.component_type);
  accessor.stride = natural_member(view, "byteStride", size);
  const size_t offset = natural_member(json, "byteOffset", 0);
  if (accessor.count == 0 || accessor.stride < size || accessor.stride > 252 ||
      offset + (accessor.count - 1) * accessor.stride + size > bytes.size())
    refuse("an accessor lies outside of its view", "accessors");
  accessor.data = bytes.data() + offset;
  return accessor;
}

Accessor attribute(const Glb& glb, const Json& primitive, const char* name, size_t components) {
  const size_t index = natural_member(member(primitive, "attributes"), name);
  const Accessor accessor = accessor_at(glb, index, "VEC" + std::to_string(components), components);
  if (accessor.component_type != component_f32) refuse("not made of floats", name);
  return accessor;
}

Point3 read_point3(const uint8_t* at) { return {read_f32(at), read_f32(at + 4), read_f32(at + 8)}; }

void append_vertices(const Glb& glb, const Json& primitive, const GlbLimits& limits, Model& model) {
  const Accessor positions = attribute(glb, primitive, "POSITION", 3);
  const Accessor normals = attribute(glb, primitive, "NORMAL", 3);
  const Accessor uvs = attribute(glb, primitive, "TEXCOORD_0", 2);
  if (normals.count != positions.count || uvs.count != positions.count)
    refuse("the attributes of a mesh differ in length", "meshes");
  if (model.positions.size() + positions.count > static_cast<uint64_t>(limits.max_vertices))
    throw Error{ErrorCode::limit, "the model has too many vertices", ""};
  for (size_t i = 0; i < positions.count; ++i) {
    model.positions.push_back(read_point3(positions.at(i)));
    model.normals.push_back(file_normal(read_point3(normals.at(i))));
    model.uvs.push_back({read_f32(uvs.at(i)), read_f32(uvs.at(i) + 4)});
  }
}

void append_triangles(const Accessor& indices, size_t first_vertex, const GlbLimits& limits,
                      Model& model) {
  if (indices.component_type == component_f32) refuse("indices are not whole numbers", "accessors");
  if (model.triangles.size() + indices.count / 3 > static_cast<uint64_t>(limits.max_triangles))
    throw Error{ErrorCode::limit, "the model has too many triangles", ""};
  const size_t vertex_count = model.positions.size() - first_vertex;
  const bool wide = indices.component_type == component_u32;
  for (size_t i = 0; i + 2 < indices.count; i += 3) {
    std::array<int, 3> triangle;
    for (size_t k = 0; k < 3; ++k) {
      const uint8_t* at = indices.at(i + k);
      const size_t index = wide ? read_u32(at) : read_u16(at);
      if (index >= vertex_count) refuse("a triangle has no such vertex", "indices");
      triangle[k] = static_cast<int>(first_vertex + index);
    }
    model.triangles.push_back(triangle);
  }
}

void append_part(const Glb& glb, const Json& node, const GlbLimits& limits, Model& model) {
  for (const char* transform : {"matrix", "translation", "rotation", "scale"})
    if (node.contains(transform))
      refuse("nodes with a transformation are not supported", transform);
  ModelPart part;
  const auto take_id = [&part](const Json& object, const char* key) {
    if (const auto id = object.find(key); id != object.end() && id->is_string())
      part.id = id->get<std::string>();
  };
  take_id(node, "name");
  if (const auto extras = node.find("extras"); extras != node.end()) {
    take_id(*extras, "part");
    if (extras->contains("c")) part.c = number((*extras)["c"], "c");
    if (extras->contains("d")) part.d = number((*extras)["d"], "d");
    if (extras->contains("flat")) part.flat = number((*extras)["flat"], "flat");
    if (extras->contains("lean")) part.lean = pair((*extras)["lean"], "lean");
  }
  part.first_triangle = static_cast<int>(model.triangles.size());
  const Json& mesh = element(glb.json, "meshes", natural_member(node, "mesh"));
  for (const Json& primitive : member(mesh, "primitives")) {
    if (natural_member(primitive, "mode", 4) != 4) refuse("only triangles are supported", "mode");
    const size_t first_vertex = model.positions.size();
    append_vertices(glb, primitive, limits, model);
    const size_t indices = natural_member(primitive, "indices");
    append_triangles(accessor_at(glb, indices, "SCALAR", 1), first_vertex, limits, model);
  }
  part.triangle_count = static_cast<int>(model.triangles.size()) - part.first_triangle;
  model.parts.push_back(std::move(part));
}

/// Sets the model's canvas as the file records it; returns the placement of the canvas in the file.
Placement recorded_canvas(const Json& extras, Model& model) {
  const auto entry = [&](const char* key, size_t index) {
    return number(element(extras, key, index), key);
  };
  model.width = entry("canvas", 0);
  model.height = entry("canvas", 1);
  const double scale = number(member(extras, "scale"), "scale");
  const Point3 origin{entry("origin", 0), entry("origin", 1), entry("origin", 2)};
  const auto is_side = [](double side) { return side >= min_canvas && side <= max_coordinate; };
  if (!is_side(model.width) || !is_side(model.height) || !(scale > 0))
    refuse("the canvas is not valid", "extras");
  return {scale, origin};
}

/// Sets a canvas that the model just fits on; returns the placement of the canvas in the file.
Placement fitted_canvas(Model& model) {
  const Box3 box = extent(model);
  const Point3 sides = box.max - box.min;
  const double longest = std::max({sides.x, sides.y, sides.z});
  if (!(longest > 0)) refuse("it has no extent");
  const double scale = longest / default_canvas;
  model.width = sides.x / scale;
  model.height = sides.y / scale;
  return {scale, {-box.min.x / scale, -box.min.y / scale, 0}};
}

void return_to_canvas(const Glb& glb, Model& model) {
  const Json& scene = element(glb.json, "scenes", natural_member(glb.json, "scene", 0));
  const auto extras = scene.find("extras");
  const bool recorded = extras != scene.end() && extras->contains("canvas");
  const Placement placement = recorded ? recorded_canvas(*extras, model) : fitted_canvas(model);
  for (std::vector<Point3>* positions : {&model.positions, &model.ink.positions})
    for (Point3& p : *positions) {
      p = (1 / placement.scale) * p + placement.origin;
      // A NaN fails this comparison.
      if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= max_extent))
        refuse("a vertex lies too far from the canvas", "positions");
    }
}

/// Returns whether a texture is shown without smoothing, as pixel art is.
bool has_nearest_filter(const Glb& glb, const Json& texture) {
  if (!texture.contains("sampler")) return false;
  const Json& sampler = element(glb.json, "samplers", natural_member(texture, "sampler"));
  constexpr size_t nearest = 9728;
  return natural_member(sampler, "magFilter", 0) == nearest;
}

Drawing read_drawing(const Glb& glb, const GlbLimits& limits) {
  if (!glb.json.contains("materials")) return {};
  const Json& material = element(glb.json, "materials", 0);
  const auto reflectance = material.find("pbrMetallicRoughness");
  if (reflectance == material.end() || !reflectance->contains("baseColorTexture")) return {};
  const size_t index = natural_member(member(*reflectance, "baseColorTexture"), "index");
  const Json& texture = element(glb.json, "textures", index);
  const Json& image = element(glb.json, "images", natural_member(texture, "source"));
  if (!image.contains("bufferView")) refuse("its texture is not embedded", "images");
  const Json& view = element(glb.json, "bufferViews", natural_member(image, "bufferView"));
  Result<Image8> decoded = decode_image(view_bytes(glb, view), limits.image);
  if (!decoded) throw Error(decoded.error());
  return {std::move(*decoded), has_nearest_filter(glb, texture) ? 1 : 0};
}

Json parse_json(ByteView text) {
  bool too_deep = false;
  const auto watch_depth = [&](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > max_json_depth;
    return !too_deep;
  };
  Json json = Json::parse(text.begin(), text.end(), watch_depth, false);
  if (too_deep) refuse("its description is nested too deeply");
  if (!json.is_object()) refuse("its description is not valid JSON");
  return json;
}

Glb split_chunks(ByteView bytes, const GlbLimits& limits) {
  if (bytes.size() < 20 || std::memcmp(bytes.data(), "glTF", 4) != 0 || read_u32(&bytes[4]) != 2)
    refuse("it is not a GLB file of version 2");
  if (read_u32(&bytes[8]) != bytes.size()) refuse("its length is wrong");
  const size_t json_size = read_u32(&bytes[12]);
  if (std::memcmp(&bytes[16], "JSON", 4) != 0 || json_size > bytes.size() - 20)
    refuse("its first chunk is not complete");
  if (json_size > static_cast<uint64_t>(limits.max_json_bytes))
    throw Error{ErrorCode::limit, "the description of the model is too large", ""};
  const ByteView rest = bytes.subspan(20 + json_size);
  if (rest.size() < 8 || std::memcmp(&rest[4], "BIN\0", 4) != 0 ||
      read_u32(rest.data()) > rest.size() - 8)
    refuse("its second chunk is not complete");
  return {parse_json(bytes.subspan(20, json_size)), rest.subspan(8, read_u32(rest.data()))};
}

bool is_ink(const Json& node) {
  const auto extras = node.find("extras");
  return extras != node.end() && extras->is_object() && extras->contains("ink");
}

/// Reads the contours, whose mesh has no normals.
void append_ink(const Glb& glb, const Json& node, const GlbLimits& limits, Model& model) {
  const Json& mesh = element(glb.json, "meshes", natural_member(node, "mesh"));
  for (const Json& primitive : member(mesh, "primitives")) {
    const Accessor positions = attribute(glb, primitive, "POSITION", 3);
    const Accessor uvs = attribute(glb, primitive, "TEXCOORD_0", 2);
    if (uvs.count != positions.count) refuse("the attributes of a mesh differ in length", "meshes");
    if (positions.count > static_cast<uint64_t>(limits.max_vertices))
      throw Error{ErrorCode::limit, "the model has too many vertices", ""};
    Model lines;
    for (size_t i = 0; i < positions.count; ++i) {
      lines.positions.push_back(read_point3(positions.at(i)));
      lines.uvs.push_back({read_f32(uvs.at(i)), read_f32(uvs.at(i) + 4)});
    }
    const size_t indices = natural_member(primitive, "indices");
    append_triangles(accessor_at(glb, indices, "SCALAR", 1), 0, limits, lines);
    model.ink = {std::move(lines.positions), std::move(lines.uvs), std::move(lines.triangles)};
  }
}

relief::DrawnModel read(ByteView bytes, const GlbLimits& limits) {
  const Glb glb = split_chunks(bytes, limits);
  relief::DrawnModel result;
  for (const Json& node : member(glb.json, "nodes"))
    if (node.contains("mesh")) {
      if (is_ink(node))
        append_ink(glb, node, limits, result.model);
      else
        append_part(glb, node, limits, result.model);
    }
  if (Status status = check_exportable(result.model, 1); !status) throw Error(status.error());
  return_to_canvas(glb, result.model);
  if (Status status = check_exportable(result.model, 1); !status) throw Error(status.error());
  result.drawing = read_drawing(glb, limits);
  return result;
}

}  // namespace

Result<relief::DrawnModel> decode_glb(ByteView bytes, const GlbLimits& limits) {
  try {
    return read(bytes, limits);
  } catch (const Error& error) {
    return error;
  }
}

}  // namespace relievo
