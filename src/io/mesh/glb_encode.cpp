#include "io/mesh/glb_encode.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "io/files/byte_writer.h"
#include "io/image/png.h"
#include "io/mesh/glb_decode.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int filter_nearest = 9728;
constexpr int filter_linear = 9729;
constexpr int filter_mipmapped = 9987;
constexpr int wrap_clamp = 33071;
constexpr int target_vertices = 34962;
constexpr int target_indices = 34963;
constexpr size_t max_u16_vertices = 65535;

/// A part's own vertices, in the order of their first use, and its triangles among them.
struct Submesh {
  int part = 0;
  std::vector<int> vertices;
  std::vector<int> indices;
};

std::vector<Submesh> split_by_part(const Model& model) {
  std::vector<Submesh> submeshes;
  std::vector<int> local(model.positions.size(), -1);
  for (size_t p = 0; p < model.parts.size(); ++p) {
    const ModelPart& part = model.parts[p];
    if (part.triangle_count == 0) continue;
    Submesh& submesh = submeshes.emplace_back();
    submesh.part = static_cast<int>(p);
    for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
      for (const int v : model.triangles[t]) {
        if (local[v] < 0) {
          local[v] = static_cast<int>(submesh.vertices.size());
          submesh.vertices.push_back(v);
        }
        submesh.indices.push_back(local[v]);
      }
    for (const int v : submesh.vertices) local[v] = -1;
  }
  return submeshes;
}

/// The two chunks of the file.
struct Asset {
  OrderedJson json;
  Bytes binary;

  /// Adds the buffer view from `begin` to the end; every view begins at a multiple of 4.
  int add_view(size_t begin, int stride, int target) {
    OrderedJson view = {
        {"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}};
    if (stride > 0) view["byteStride"] = stride;
    if (target > 0) view["target"] = target;
    json["bufferViews"].push_back(std::move(view));
    binary.resize((binary.size() + 3) / 4 * 4);
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }

  int add_accessor(OrderedJson accessor) {
    json["accessors"].push_back(std::move(accessor));
    return static_cast<int>(json["accessors"].size()) - 1;
  }
};

/// Adds one view with an N-vector per vertex of all parts, `get(v)`, and an accessor per part;
/// returns the accessors' indices.
template <size_t N, class Get>
std::vector<int> add_vectors(Asset& asset, const std::vector<Submesh>& submeshes, Get get) {
  const size_t begin = asset.binary.size();
  const size_t view = asset.json["bufferViews"].size();
  std::vector<int> accessors;
  for (const Submesh& submesh : submeshes) {
    OrderedJson accessor = {{"bufferView", view},
                            {"byteOffset", asset.binary.size() - begin},
                            {"componentType", component_f32},
                            {"count", submesh.vertices.size()},
                            {"type", "VEC" + std::to_string(N)}};
    std::array<float, N> low = get(submesh.vertices.front());
    std::array<float, N> high = low;
    for (const int v : submesh.vertices) {
      const std::array<float, N> vector = get(v);
      for (size_t k = 0; k < N; ++k) {
        append_f32(asset.binary, vector[k]);
        low[k] = std::min(low[k], vector[k]);
        high[k] = std::max(high[k], vector[k]);
      }
    }
    accessor["min"] = low;
    accessor["max"] = high;
    accessors.push_back(asset.add_accessor(std::move(accessor)));
  }
  asset.add_view(begin, 4 * N, target_vertices);
  return accessors;
}

std::array<float, 3> narrow(Point3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

std::vector<int> add_indices(Asset& asset, const std::vector<Submesh>& submeshes) {
  const bool short_indices = std::all_of(
      submeshes.begin(), submeshes.end(),
      [](const Submesh& submesh) { return submesh.vertices.size() <= max_u16_vertices; });
  const size_t begin = asset.binary.size();
  const int view = static_cast<int>(asset.json["bufferViews"].size());
  std::vector<int> accessors;
  for (const Submesh& submesh : submeshes) {
    const size_t offset = asset.binary.size() - begin;
    for (const int index : submesh.indices) {
      if (short_indices)
        append_u16(asset.binary, static_cast<uint16_t>(index));
      else
        append_u32(asset.binary, static_cast<uint32_t>(index));
    }
    accessors.push_back(
        asset.add_accessor({{"bufferView", view},
                            {"byteOffset", offset},
                            {"componentType", short_indices ? component_u16 : component_u32},
                            {"count", submesh.indices.size()},
                            {"type", "SCALAR"}}));
  }
  asset.add_view(begin, 0, target_indices);
  return accessors;
}

/// Adds a view with an N-vector per item, `get(i)`; returns its accessor.
template <size_t N, class Get>
int add_list(Asset& asset, size_t count, Get get) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return add_vectors<N>(asset, {Submesh{0, std::move(all), {}}}, get).front();
}

/// Adds a node for the contours, with a material that needs no light and hides back faces.
void add_ink(Asset& asset, const InkMesh& ink, const Placement& placement) {
  const int positions = add_list<3>(asset, ink.positions.size(), [&](int v) {
    return narrow(place(placement, ink.positions[v]));
  });
  const int uvs = add_list<2>(asset, ink.uvs.size(), [&](int v) {
    return std::array<float, 2>{static_cast<float>(ink.uvs[v].x), static_cast<float>(ink.uvs[v].y)};
  });
  Submesh submesh;
  submesh.vertices.resize(ink.positions.size());
  for (const std::array<int, 3>& t : ink.triangles)
    submesh.indices.insert(submesh.indices.end(), t.begin(), t.end());
  const int indices = add_indices(asset, {submesh}).front();
  OrderedJson primitive = {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                           {"indices", indices},
                           {"material", 1}};
  asset.json["nodes"].push_back(
      {{"name", "ink"}, {"mesh", asset.json["meshes"].size()}, {"extras", {{"ink", true}}}});
  asset.json["meshes"].push_back(
      {{"name", "ink"}, {"primitives", OrderedJson::array({std::move(primitive)})}});
  asset.json["materials"].push_back(
      {{"name", "ink"},
       {"pbrMetallicRoughness", {{"metallicFactor", 0}}},
       {"extensions", {{"KHR_materials_unlit", OrderedJson::object()}}}});
  asset.json["extensionsUsed"] = {"KHR_materials_unlit"};
}

/// Adds a node for each part and one called `name` above them; a part alone takes that name.
void add_nodes(Asset& asset, const Model& model, const Placement& placement,
               const std::string& name) {
  const std::vector<Submesh> submeshes = split_by_part(model);
  const std::vector<int> positions = add_vectors<3>(
      asset, submeshes, [&](int v) { return narrow(place(placement, model.positions[v])); });
  const std::vector<int> normals = add_vectors<3>(
      asset, submeshes, [&](int v) { return narrow(file_normal(model.normals[v])); });
  const std::vector<int> uvs = add_vectors<2>(asset, submeshes, [&](int v) {
    return std::array<float, 2>{static_cast<float>(model.uvs[v].x),
                                static_cast<float>(model.uvs[v].y)};
  });
  const std::vector<int> indices = add_indices(asset, submeshes);
  for (size_t i = 0; i < submeshes.size(); ++i) {
    const int order = submeshes[i].part;
    const ModelPart& part = model.parts[order];
    OrderedJson primitive = {
        {"attributes",
         {{"POSITION", positions[i]}, {"NORMAL", normals[i]}, {"TEXCOORD_0", uvs[i]}}},
        {"indices", indices[i]},
        {"material", 0}};
    asset.json["meshes"].push_back(
        {{"name", part.id}, {"primitives", OrderedJson::array({std::move(primitive)})}});
    OrderedJson extras = {{"part", part.id}, {"order", order}, {"c", part.c}, {"d", part.d}};
    if (part.flat != 0) extras["flat"] = part.flat;
    if (part.lean != Point2{}) extras["lean"] = {part.lean.x, part.lean.y};
    asset.json["nodes"].push_back({{"name", submeshes.size() == 1 ? name : part.id},
                                   {"mesh", i},
                                   {"extras", std::move(extras)}});
  }
  if (!model.ink.triangles.empty()) add_ink(asset, model.ink, placement);
  std::vector<size_t> parts(asset.json["nodes"].size());
  std::iota(parts.begin(), parts.end(), size_t{0});
  if (parts.size() > 1) asset.json["nodes"].push_back({{"name", name}, {"children", parts}});
  asset.json["scenes"][0]["nodes"] = {asset.json["nodes"].size() - 1};
}

Status add_texture(Asset& asset, const Model& model, const Drawing& drawing) {
  const Result<Bytes> png = encode_png(relief::model_texture(model, drawing));
  if (!png) return png.error();
  const size_t begin = asset.binary.size();
  asset.binary.insert(asset.binary.end(), png->begin(), png->end());
  const int view = asset.add_view(begin, 0, 0);
  const OrderedJson image = {{"bufferView", view}, {"mimeType", "image/png"}};
  const bool own_pixels = drawing.pixel_art > 0;
  const OrderedJson sampler = {{"magFilter", own_pixels ? filter_nearest : filter_linear},
                               {"minFilter", own_pixels ? filter_nearest : filter_mipmapped},
                               {"wrapS", wrap_clamp},
                               {"wrapT", wrap_clamp}};
  const OrderedJson texture = {{"sampler", 0}, {"source", 0}};
  asset.json["images"] = OrderedJson::array({image});
  asset.json["samplers"] = OrderedJson::array({sampler});
  asset.json["textures"] = OrderedJson::array({texture});
  for (OrderedJson& material : asset.json["materials"])
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  return Done{};
}

OrderedJson skeleton(const Model& model, const Placement& placement, const std::string& name) {
  const Point3 origin = placement.origin;
  const OrderedJson extras = {{"canvas", OrderedJson::array({model.width, model.height})},
                              {"origin", OrderedJson::array({origin.x, origin.y, origin.z})},
                              {"scale", placement.scale}};
  const OrderedJson scene = {{"name", name}, {"nodes", OrderedJson::array()}, {"extras", extras}};
  const OrderedJson reflectance = {{"baseColorFactor", OrderedJson::array({1, 1, 1, 1})},
                                   {"metallicFactor", 0},
                                   {"roughnessFactor", 0.9}};
  const OrderedJson material = {
      {"name", "drawing"}, {"pbrMetallicRoughness", reflectance}, {"doubleSided", true}};
  return {{"asset", {{"version", "2.0"}, {"generator", "relievo " RELIEVO_VERSION}}},
          {"scene", 0},
          {"scenes", OrderedJson::array({scene})},
          {"nodes", OrderedJson::array()},
          {"meshes", OrderedJson::array()},
          {"materials", OrderedJson::array({material})},
          {"accessors", OrderedJson::array()},
          {"bufferViews", OrderedJson::array()}};
}

Result<Bytes> pack(Asset& asset) {
  const OrderedJson buffer = {{"byteLength", asset.binary.size()}};
  asset.json["buffers"] = OrderedJson::array({buffer});
  std::string text = asset.json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const uint64_t total = 28 + uint64_t{text.size()} + asset.binary.size();
  if (total > std::numeric_limits<uint32_t>::max())
    return Error{ErrorCode::limit, "the model does not fit into a GLB file of 4 GB", ""};
  Bytes bytes;
  bytes.reserve(static_cast<size_t>(total));
  append_text(bytes, "glTF");
  append_u32(bytes, 2);
  append_u32(bytes, static_cast<uint32_t>(total));
  append_u32(bytes, static_cast<uint32_t>(text.size()));
  append_text(bytes, "JSON");
  append_text(bytes, text);
  append_u32(bytes, static_cast<uint32_t>(asset.binary.size()));
  append_text(bytes, std::string_view("BIN\0", 4));
  bytes.insert(bytes.end(), asset.binary.begin(), asset.binary.end());
  return bytes;
}

}  // namespace

Result<Bytes> encode_glb(const Model& model, const Drawing* drawing, const ExportOptions& options,
                         const std::string& name) {
  if (Status status = check_exportable(model, options.size_mm); !status) return status.error();
  const Placement placement = centred_placement(model, options.size_mm / 1000, options.grounded);
  Asset asset;
  asset.json = skeleton(model, placement, name);
  add_nodes(asset, model, placement, name);
  if (drawing != nullptr && !drawing->rgba.empty())
    if (Status status = add_texture(asset, model, *drawing); !status) return status.error();
  return pack(asset);
}

}  // namespace relievo
