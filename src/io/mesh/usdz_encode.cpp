#include "io/mesh/usdz_encode.h"

#include <initializer_list>
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
}
)";

constexpr const char* usda_clay = R"( = (0.8, 0.75, 0.68)
            token outputs:surface
        }
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

/// Appends one line `declaration = [...]`; `fill` appends values, each with a comma.
template <class Fill>
void append_array(Bytes& usda, const char* declaration, Fill fill) {
  append_text(usda, std::string("        ") + declaration + " = [");
  fill();
  // The format allows no comma at the end.
  usda.resize(usda.size() - 2);
  append_text(usda, "]");
}

void append_usd_mesh(Bytes& usda, const Model& model, double size_mm) {
  Placement placement = centred_placement(model, size_mm / 1000);
  placement.origin.y = extent(model).min.y;
  append_text(usda,
              "    def Mesh \"mesh\" (prepend apiSchemas = [\"MaterialBindingAPI\"])\n    {\n"
              "        uniform bool doubleSided = 1\n"
              "        uniform token subdivisionScheme = \"none\"\n"
              "        rel material:binding = </relief/drawing>\n");
  append_array(usda, "int[] faceVertexCounts", [&] {
    for (size_t t = 0; t < model.triangles.size(); ++t) append_text(usda, "3, ");
  });
  append_text(usda, "\n");
  append_array(usda, "int[] faceVertexIndices", [&] {
    for (const std::array<int, 3>& t : model.triangles)
      for (const int v : t) append_text(usda, std::to_string(v) + ", ");
  });
  append_text(usda, "\n");
  append_array(usda, "point3f[] points", [&] {
    for (const Point3& position : model.positions) {
      const Point3 p = place(placement, position);
      append_tuple(usda, {p.x, p.y, p.z});
    }
  });
  append_text(usda, "\n");
  append_array(usda, "normal3f[] normals", [&] {
    for (const Point3& normal : model.normals) {
      const Point3 n = file_normal(normal);
      append_tuple(usda, {n.x, n.y, n.z});
    }
  });
  append_text(usda, " (interpolation = \"vertex\")\n");
  append_array(usda, "texCoord2f[] primvars:st", [&] {
    for (const Point2& uv : model.uvs) append_tuple(usda, {uv.x, 1 - uv.y});
  });
  append_text(usda, " (interpolation = \"vertex\")\n    }\n");
}

}  // namespace

Result<Bytes> encode_usdz(const Model& model, const Drawing* drawing, double size_mm) {
  if (Status status = check_exportable(model, size_mm); !status) return status.error();
  const bool drawn = drawing != nullptr && !drawing->rgba.empty();
  std::vector<ArchiveEntry> entries(1);
  entries[0].name = "relief.usda";
  Bytes& usda = entries[0].bytes;
  append_text(usda, usda_head);
  append_usd_mesh(usda, model, size_mm);
  append_text(usda, usda_shader);
  append_text(usda, drawn ? usda_texture : usda_clay);
  if (drawn) {
    auto png = encode_png(relief::model_texture(model, *drawing));
    if (!png) return png.error();
    entries.push_back({"drawing.png", std::move(*png)});
  }
  return pack_aligned(entries);
}

}  // namespace relievo
