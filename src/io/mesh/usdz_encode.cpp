#include "io/mesh/usdz_encode.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "io/archive/archive.h"
#include "io/files/byte_writer.h"
#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

constexpr const char* usda_head = R"(#usda 1.0
(
    defaultPrim = "relief"
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "relief" (kind = "component")
{
)";

constexpr const char* usda_shader = R"(    def Material "drawing"
    {
        token outputs:surface.connect = </relief/drawing/surface.outputs:surface>
        def Shader "surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            float inputs:roughness = 0.9
            float inputs:metallic = 0
            color3f inputs:diffuseColor)";

constexpr const char* usda_texture = R"(.connect = </relief/drawing/texture.outputs:rgb>
            token outputs:surface
        }
        def Shader "texture"
        {
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @drawing.png@
            float2 inputs:st.connect = </relief/drawing/place.outputs:result>
            token inputs:sourceColorSpace = "sRGB"
            float3 outputs:rgb
        }
        def Shader "place"
        {
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }
    }
)";

constexpr const char* usda_clay = R"( = (0.8, 0.75, 0.68)
            token outputs:surface
        }
    }
)";

/// Lines show their own colour, whatever the light.
constexpr const char* usda_ink = R"(    def Material "ink"
    {
        token outputs:surface.connect = </relief/finish/surface.outputs:surface>
        def Shader "surface"
        {
            uniform token info:id = "UsdPreviewSurface"
            float inputs:roughness = 1
            color3f inputs:diffuseColor = (0, 0, 0)
            color3f inputs:emissiveColor.connect = </relief/drawing/texture.outputs:rgb>
            token outputs:surface
        }
    }
)";

void append_tuple(Bytes& usda, std::initializer_list<double> numbers) {
  const char* before = "(";
  for (const double number : numbers) {
    append_text(usda, before);
    append_text(usda, shortest_text(static_cast<float>(number)));
    before = ", ";
  }
  append_text(usda, "), ");
}

/// Appends one line `declaration = [...]` and its end; `fill` appends values, each with a comma.
template <class Fill>
void append_array(Bytes& usda, const char* declaration, const char* end, Fill fill) {
  append_text(usda, std::string("        ") + declaration + " = [");
  fill();
  // The format allows no comma at the end.
  usda.resize(usda.size() - 2);
  append_text(usda, std::string("]") + end + "\n");
}

/// Appends the start of a mesh.
void append_usd_faces(Bytes& usda, const char* name, const char* material, bool double_sided,
                      const std::vector<std::array<int, 3>>& triangles) {
  append_text(usda, std::string("    def Mesh \"") + name +
                        "\" (prepend apiSchemas = [\"MaterialBindingAPI\"])\n    {\n"
                        "        uniform bool doubleSided = " +
                        (double_sided ? "1" : "0") +
                        "\n        uniform token subdivisionScheme = \"none\"\n"
                        "        rel material:binding = </relief/" +
                        material + ">\n");
  append_array(usda, "int[] faceVertexCounts", "", [&] {
    for (size_t t = 0; t < triangles.size(); ++t) append_text(usda, "3, ");
  });
  append_array(usda, "int[] faceVertexIndices", "", [&] {
    for (const std::array<int, 3>& t : triangles)
      for (const int v : t) append_text(usda, std::to_string(v) + ", ");
  });
}

constexpr const char* per_vertex = " (interpolation = \"vertex\")";

void append_usd_points(Bytes& usda, const Placement& placement,
                       const std::vector<Point3>& positions, const std::vector<Point2>& uvs) {
  append_array(usda, "point3f[] points", "", [&] {
    for (const Point3& position : positions) {
      const Point3 p = place(placement, position);
      append_tuple(usda, {p.x, p.y, p.z});
    }
  });
  append_array(usda, "texCoord2f[] primvars:st", per_vertex, [&] {
    for (const Point2& uv : uvs) append_tuple(usda, {uv.x, 1 - uv.y});
  });
}

void append_usd_meshes(Bytes& usda, const Model& model, double size_mm) {
  const Placement placement = centred_placement(model, size_mm / 1000, true);
  append_usd_faces(usda, "mesh", "drawing", true, model.triangles);
  append_usd_points(usda, placement, model.positions, model.uvs);
  append_array(usda, "normal3f[] normals", per_vertex, [&] {
    for (const Point3& normal : model.normals) {
      const Point3 n = file_normal(normal);
      append_tuple(usda, {n.x, n.y, n.z});
    }
  });
  append_text(usda, "    }\n");
  if (model.ink.triangles.empty()) return;
  append_usd_faces(usda, "lines", "ink", false, model.ink.triangles);
  append_usd_points(usda, placement, model.ink.positions, model.ink.uvs);
  append_text(usda, "    }\n");
}

/// Alignment of the entries, which the format demands.
constexpr size_t alignment = 64;
constexpr size_t local_header = 30;
constexpr size_t extra_header = 4;
/// Id of an extra field for padding, as the tools of the format's authors write it.
constexpr uint16_t padding_field = 0x1986;
constexpr uint16_t version = 20;
constexpr uint16_t first_of_1980 = (1 << 5) | 1;

uint32_t checksum(const Bytes& bytes) {
  uLong crc = crc32(0, nullptr, 0);
  return static_cast<uint32_t>(crc32_z(crc, bytes.data(), bytes.size()));
}

/// Appends the fields that both headers of an entry have.
void append_facts(Bytes& zip, const ArchiveEntry& entry, size_t padding) {
  append_u16(zip, version);
  append_u16(zip, 0);  // flags
  append_u16(zip, 0);  // stored
  append_u16(zip, 0);  // midnight
  append_u16(zip, first_of_1980);
  append_u32(zip, checksum(entry.bytes));
  append_u32(zip, static_cast<uint32_t>(entry.bytes.size()));
  append_u32(zip, static_cast<uint32_t>(entry.bytes.size()));
  append_u16(zip, static_cast<uint16_t>(entry.name.size()));
  append_u16(zip, static_cast<uint16_t>(padding));
}

void append_entry(Bytes& zip, const ArchiveEntry& entry) {
  const size_t used = zip.size() + local_header + entry.name.size() + extra_header;
  const size_t fill = (alignment - used % alignment) % alignment;
  append_text(zip, "PK\3\4");
  append_facts(zip, entry, extra_header + fill);
  append_text(zip, entry.name);
  append_u16(zip, padding_field);
  append_u16(zip, static_cast<uint16_t>(fill));
  zip.insert(zip.end(), fill, 0);
  zip.insert(zip.end(), entry.bytes.begin(), entry.bytes.end());
}

void append_directory(Bytes& zip, const ArchiveEntry& entry, size_t offset) {
  append_text(zip, "PK\1\2");
  append_u16(zip, version);
  append_facts(zip, entry, 0);
  append_u16(zip, 0);  // comment
  append_u16(zip, 0);  // disk
  append_u16(zip, 0);  // internal attributes
  append_u32(zip, 0);  // external attributes
  append_u32(zip, static_cast<uint32_t>(offset));
  append_text(zip, entry.name);
}

/// Packs a zip archive of the entries in their order, stored, with the bytes of each at a multiple
/// of 64. Error: `limit` above 4 GB.
Result<Bytes> pack_aligned(const std::vector<ArchiveEntry>& entries) {
  size_t total = 0;
  for (const ArchiveEntry& entry : entries) total += entry.bytes.size() + 1000;
  if (total > std::numeric_limits<uint32_t>::max())
    return Error{ErrorCode::limit, "the archive would be larger than 4 GB", ""};
  Bytes zip;
  zip.reserve(total);
  std::vector<size_t> offsets;
  for (const ArchiveEntry& entry : entries) {
    offsets.push_back(zip.size());
    append_entry(zip, entry);
  }
  const size_t directory = zip.size();
  for (size_t i = 0; i < entries.size(); ++i) append_directory(zip, entries[i], offsets[i]);
  const size_t length = zip.size() - directory;
  append_text(zip, "PK\5\6");
  append_u32(zip, 0);  // disks
  append_u16(zip, static_cast<uint16_t>(entries.size()));
  append_u16(zip, static_cast<uint16_t>(entries.size()));
  append_u32(zip, static_cast<uint32_t>(length));
  append_u32(zip, static_cast<uint32_t>(directory));
  append_u16(zip, 0);  // comment
  return zip;
}

}  // namespace

Result<Bytes> encode_usdz(const Model& model, const Drawing* drawing, double size_mm) {
  if (Status status = check_exportable(model, size_mm); !status) return status.error();
  const bool drawn = drawing != nullptr && !drawing->rgba.empty();
  std::vector<ArchiveEntry> entries(1);
  entries[0].name = "relief.usda";
  Bytes& usda = entries[0].bytes;
  append_text(usda, usda_head);
  append_usd_meshes(usda, model, size_mm);
  append_text(usda, usda_shader);
  append_text(usda, drawn ? usda_texture : usda_clay);
  if (!model.ink.triangles.empty()) append_text(usda, usda_ink);
  append_text(usda, "}\n");
  if (drawn) {
    auto png = encode_png(relief::model_texture(model, *drawing));
    if (!png) return png.error();
    entries.push_back({"drawing.png", std::move(*png)});
  }
  return pack_aligned(entries);
}

}  // namespace relievo
