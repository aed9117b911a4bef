#include "io/mesh/html_encode.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "io/files/byte_writer.h"
#include "io/image/png.h"
#include "io/mesh/html_viewer.h"
#include "io/mesh/placement.h"
#include "relief/finish/model_texture.h"

namespace relievo {
namespace {

void append_base64(Bytes& text, const Bytes& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0U);
    for (size_t k = 0; k < 4; ++k)
      text.push_back(static_cast<uint8_t>(k <= count ? digits[group >> (18 - 6 * k) & 63] : '='));
  }
}

std::string escaped(const std::string& title) {
  std::string text;
  for (const char c : title) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else
      text += c;
  }
  return text;
}

/// Returns the vertices of the surface, then those of its ink, centred in a box from -1 to 1.
Bytes packed_vertices(const Model& model) {
  Placement placement = centred_placement(model, 2);
  const Box3 box = extent(model);
  placement.origin.z = 0.5 * (box.min.z + box.max.z);
  Bytes bytes;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 p = place(placement, model.positions[v]);
    const Point3 n = file_normal(model.normals[v]);
    append_f32s(bytes, {p.x, p.y, p.z, n.x, n.y, n.z, model.uvs[v].x, model.uvs[v].y});
  }
  for (size_t v = 0; v < model.ink.positions.size(); ++v) {
    const Point3 p = place(placement, model.ink.positions[v]);
    append_f32s(bytes, {p.x, p.y, p.z, 0, 0, 1, model.ink.uvs[v].x, model.ink.uvs[v].y});
  }
  return bytes;
}

}  // namespace

Result<Bytes> encode_html(const Model& model, const Drawing* drawing, const std::string& title) {
  if (Status status = check_exportable(model, 1); !status) return status.error();
  Bytes html;
  append_text(html, viewer_head);
  append_text(html, "<title>" + escaped(title) + "</title>\n<canvas></canvas>\n" +
                        "<p>Drag to turn, wheel or two fingers to come nearer.</p>\n" +
                        "<script>\nconst model = {\nvertices: \"");
  append_base64(html, packed_vertices(model));
  append_text(html, "\",\ntriangles: \"");
  Bytes triangles;
  for (const std::array<int, 3>& t : model.triangles)
    for (const int v : t) append_u32(triangles, static_cast<uint32_t>(v));
  for (const std::array<int, 3>& t : model.ink.triangles)
    for (const int v : t) append_u32(triangles, static_cast<uint32_t>(model.positions.size() + v));
  append_base64(html, triangles);
  append_text(html, "\",\nink: " + std::to_string(3 * model.ink.triangles.size()));
  append_text(html, ",\npicture: \"");
  if (drawing != nullptr && !drawing->rgba.empty()) {
    const auto png = encode_png(relief::model_texture(model, *drawing));
    if (!png) return png.error();
    append_text(html, "data:image/png;base64,");
    append_base64(html, *png);
  }
  const bool own_pixels = drawing != nullptr && drawing->pixel_art > 0;
  append_text(html, own_pixels ? "\",\nfilter: \"NEAREST\" };\n" : "\" };\n");
  append_text(html, viewer_script);
  append_text(html, "</script>\n</html>\n");
  return html;
}

}  // namespace relievo
