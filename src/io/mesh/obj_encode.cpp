#include "io/mesh/obj_encode.h"

#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "io/files/byte_writer.h"
#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

void append_line(Bytes& bytes, std::string_view keyword, std::initializer_list<double> numbers) {
  append_text(bytes, keyword);
  for (const double number : numbers) {
    bytes.push_back(' ');
    append_text(bytes, shortest_text(static_cast<float>(number)));
  }
  bytes.push_back('\n');
}

void append_part(Bytes& obj, const Model& model, const ModelPart& part,
                 const std::vector<int>& position) {
  append_text(obj, "o " + obj_file_name(part.id) + "\nusemtl drawing\n");
  for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    append_text(obj, "f");
    for (const int v : model.triangles[t]) {
      const std::string index = std::to_string(v + 1);
      append_text(obj, " " + std::to_string(position[v] + 1) + "/" + index + "/" + index);
    }
    append_text(obj, "\n");
  }
}

std::string material(const std::string& texture) {
  std::string text = "newmtl drawing\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\n";
  if (!texture.empty()) text += "map_Kd " + texture + "\n";
  return text;
}

}  // namespace

std::string obj_file_name(const std::string& name) {
  std::string result = name.empty() ? "_" : name;
  for (char& c : result)
    if (static_cast<unsigned char>(c) <= ' ' || c == 0x7f || c == '#' || c == '\\') c = '_';
  return result;
}

Result<ObjFiles> encode_obj(const Model& model, const Drawing* drawing,
                            const ExportOptions& options, const std::string& file_name) {
  if (Status status = check_exportable(model, options.size_mm); !status) return status.error();
  ObjFiles files;
  const std::string name = obj_file_name(file_name);
  std::string texture;
  if (drawing != nullptr && !drawing->rgba.empty()) {
    Result<Bytes> png = encode_png(relief::model_texture(model, *drawing));
    if (!png) return png.error();
    files.png = std::move(*png);
    texture = name + ".png";
  }
  append_text(files.mtl, material(texture));
  append_text(files.obj, "# relievo " RELIEVO_VERSION ", millimetres\nmtllib " + name + ".mtl\n");
  const SharedVertices shared =
      share_vertices(model, centred_placement(model, options.size_mm, options.grounded));
  for (const auto& [x, y, z] : shared.places) append_line(files.obj, "v", {x, y, z});
  for (const Point2& uv : model.uvs) append_line(files.obj, "vt", {uv.x, 1 - uv.y});
  for (const Point3& normal : model.normals) {
    const Point3 n = file_normal(normal);
    append_line(files.obj, "vn", {n.x, n.y, n.z});
  }
  for (const ModelPart& part : model.parts)
    if (part.triangle_count > 0) append_part(files.obj, model, part, shared.number);
  return files;
}

}  // namespace relievo
