#include "io/mesh/ply_encode.h"

#include <algorithm>
#include <cmath>

#include "io/files/byte_writer.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

std::string header(const Model& model, bool coloured, const std::string& texture_file) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\ncomment relievo " RELIEVO_VERSION ", millimetres\n";
  if (!texture_file.empty()) text += "comment TextureFile " + texture_file + "\n";
  text += "element vertex " + std::to_string(model.positions.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
    text += std::string("property float ") + name + "\n";
  if (coloured)
    for (const char* name : {"red", "green", "blue"})
      text += std::string("property uchar ") + name + "\n";
  text += "element face " + std::to_string(model.triangles.size()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

int pixel_at(double coordinate, int size) {
  return static_cast<int>(std::clamp(std::floor(coordinate * size), 0.0, size - 1.0));
}

}  // namespace

Result<Bytes> encode_ply(const Model& model, const Drawing* drawing, const ExportOptions& options,
                         const std::string& texture_file) {
  if (Status status = check_exportable(model, options.size_mm); !status) return status.error();
  if (texture_file.find_first_of("\r\n") != std::string::npos)
    return Error{ErrorCode::usage, "the name of the texture must be one line", texture_file};
  const Image8 texture = drawing != nullptr ? relief::model_texture(model, *drawing) : Image8{};
  const Placement placement = centred_placement(model, options.size_mm, options.grounded);
  Bytes ply;
  append_text(ply, header(model, !texture.empty(), texture_file));
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 p = place(placement, model.positions[v]);
    const Point3 n = file_normal(model.normals[v]);
    const Point2 uv = model.uvs[v];
    append_f32s(ply, {p.x, p.y, p.z, n.x, n.y, n.z, uv.x, 1 - uv.y});
    for (int c = 0; c < 3 && !texture.empty(); ++c)
      ply.push_back(texture.at(pixel_at(uv.x, texture.width), pixel_at(uv.y, texture.height), c));
  }
  for (const std::array<int, 3>& triangle : model.triangles) {
    ply.push_back(3);
    for (const int v : triangle) append_u32(ply, static_cast<uint32_t>(v));
  }
  return ply;
}

}  // namespace relievo
