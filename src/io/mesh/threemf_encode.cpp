#include "io/mesh/threemf_encode.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/archive/zip_archive.h"
#include "io/files/number_text.h"
#include "io/image/png.h"
#include "io/mesh/filament_colours.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

constexpr const char* xml_head = R"(<?xml version="1.0" encoding="UTF-8"?>)"
                                 "\n";

constexpr const char* content_types =
    R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
<Default Extension="png" ContentType="image/png"/>
</Types>
)";

std::string relationship(const std::string& type, const std::string& target) {
  return R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target=")" +
         target + R"(" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/)" +
         type + "\"/>\n</Relationships>\n";
}

/// Returns the code of slicers for a whole triangle of one filament, counted from 1: two bits for
/// "not subdivided" and two for the filament; from 3 on four bits more. The last nibble is first.
std::string paint_code(int filament) {
  if (filament < 3) return filament == 1 ? "4" : "8";
  std::string code(1, "0123456789ABCDEF"[filament - 3]);
  return code + "C";
}

std::string hex_colour(const std::array<uint8_t, 3>& rgb) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02X%02X%02X", rgb[0], rgb[1], rgb[2]);
  return text.data();
}

void append_attribute(std::string& xml, std::string_view name, const std::string& value) {
  xml.append(name).append(value).push_back('"');
}

class ModelWriter {
 public:
  ModelWriter(const Model& model, const Placement& placement)
      : model_(model), shared_(share_vertices(model, placement)) {}

  void paint(FilamentColours colours, Slicer slicer) {
    colours_ = std::move(colours);
    paint_attribute_ =
        slicer == Slicer::prusa ? " slic3rpe:mmu_segmentation=\"" : " paint_color=\"";
  }

  std::string write() && {
    xml_.append(
        R"(<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06">
<metadata name="Application">relievo )" RELIEVO_VERSION R"(</metadata>
)");
    append_filaments();
    xml_.append("<resources>\n");
    if (painted()) append_texture();
    xml_.append(painted() ? R"(<object id="3" type="model" pid="2" pindex="0"><mesh>)"
                          : R"(<object id="3" type="model"><mesh>)");
    append_mesh();
    xml_.append(R"(</mesh></object>
</resources>
<build><item objectid="3"/></build>
</model>
)");
    return std::move(xml_);
  }

 private:
  bool painted() const { return !colours_.colours.empty(); }

  void append_filaments() {
    if (!painted()) return;
    std::string text;
    for (size_t k = 0; k < colours_.colours.size(); ++k)
      text += (k > 0 ? ", " : "") + std::to_string(k + 1) + " " + hex_colour(colours_.colours[k]);
    xml_.append("<metadata name=\"Description\">Filaments: " + text + "</metadata>\n");
  }

  void append_texture() {
    xml_.append(
        R"(<m:texture2d id="1" path="/3D/Textures/drawing.png" contenttype="image/png" tilestyleu="clamp" tilestylev="clamp"/>
<m:texture2dgroup id="2" texid="1">
)");
    for (const Point2 uv : model_.uvs) {
      append_attribute(xml_, "<m:tex2coord u=\"", shortest_text(static_cast<float>(uv.x)));
      append_attribute(xml_, " v=\"", shortest_text(static_cast<float>(1 - uv.y)));
      xml_.append("/>\n");
    }
    xml_.append("</m:texture2dgroup>\n");
  }

  void append_mesh() {
    xml_.append("<vertices>\n");
    for (const std::array<float, 3>& p : shared_.places) {
      append_attribute(xml_, "<vertex x=\"", shortest_text(p[0]));
      append_attribute(xml_, " y=\"", shortest_text(p[1]));
      append_attribute(xml_, " z=\"", shortest_text(p[2]));
      xml_.append("/>\n");
    }
    xml_.append("</vertices>\n<triangles>\n");
    for (size_t t = 0; t < model_.triangles.size(); ++t) append_triangle(t);
    xml_.append("</triangles>\n");
  }

  void append_triangle(size_t t) {
    const std::array<int, 3>& triangle = model_.triangles[t];
    append_attribute(xml_, "<triangle v1=\"", std::to_string(shared_.number[triangle[0]]));
    append_attribute(xml_, " v2=\"", std::to_string(shared_.number[triangle[1]]));
    append_attribute(xml_, " v3=\"", std::to_string(shared_.number[triangle[2]]));
    if (painted()) {
      append_attribute(xml_, " pid=\"2\" p1=\"", std::to_string(triangle[0]));
      append_attribute(xml_, " p2=\"", std::to_string(triangle[1]));
      append_attribute(xml_, " p3=\"", std::to_string(triangle[2]));
      const std::string code = paint_code(colours_.triangle[t] + 1);
      append_attribute(xml_, paint_attribute_, code);
    }
    xml_.append("/>\n");
  }

  const Model& model_;
  SharedVertices shared_;
  FilamentColours colours_;
  const char* paint_attribute_ = "";
  std::string xml_;
};

Bytes xml_bytes(const std::string& text) {
  const std::string xml = xml_head + text;
  return {xml.begin(), xml.end()};
}

}  // namespace

Result<std::vector<ArchiveEntry>> threemf_entries(const Model& model, const Drawing* drawing,
                                                  const ExportOptions& options) {
  if (Status status = check_exportable(model, options.size_mm); !status) return status.error();
  ModelWriter writer(model, octant_placement(model, options.size_mm, options.standing));
  std::vector<ArchiveEntry> entries = {
      {"[Content_Types].xml", xml_bytes(content_types)},
      {"_rels/.rels", xml_bytes(relationship("3dmodel", "/3D/3dmodel.model"))}};
  if (drawing != nullptr) {
    const Image8 texture = relief::model_texture(model, *drawing);
    auto png = encode_png(texture);
    if (!png) return png.error();
    writer.paint(reduce_colours(model, texture, options.filaments), options.slicer);
    entries.push_back({"3D/_rels/3dmodel.model.rels",
                       xml_bytes(relationship("3dtexture", "/3D/Textures/drawing.png"))});
    entries.push_back({"3D/Textures/drawing.png", std::move(*png)});
  }
  entries.push_back({"3D/3dmodel.model", xml_bytes(std::move(writer).write())});
  return entries;
}

#ifndef __EMSCRIPTEN__

Result<Bytes> encode_3mf(const Model& model, const Drawing* drawing, const ExportOptions& options) {
  const auto entries = threemf_entries(model, drawing, options);
  return entries ? pack_archive(*entries) : entries.error();
}

#endif

}  // namespace relievo
