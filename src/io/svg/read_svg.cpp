#include "io/svg/read_svg.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "io/image/png.h"
#include "io/svg/annotations.h"
#include "io/svg/stylesheet.h"
#include "io/svg/svg_document.h"
#include "io/svg/svg_drawing.h"
#include "io/svg/svg_values.h"

namespace relievo {
namespace {

using understanding::LayeredDrawing;

using Elements = std::vector<pugi::xml_node>;

bool is_annotated(const SvgDrawing& drawing) {
  return std::any_of(drawing.groups.begin(), drawing.groups.end(), [](const SvgGroup& group) {
    return group.mark == SvgMark::part || has_part_values(group.element);
  });
}

bool has_notes(const SvgDrawing& drawing) {
  return std::any_of(drawing.shapes.begin(), drawing.shapes.end(),
                     [](const SvgShape& shape) { return shape.is_note(); });
}

/// Takes the parts and their joins, cues and relations; `lines` become the elements that draw
/// joins and cues.
Status take_annotations(const SvgDrawing& drawing, bool layers, LayeredDrawing& result,
                        Elements& lines) {
  auto parts = annotated_parts(drawing, layers);
  if (!parts) return parts.error();
  Scene& scene = result.scene;
  if (Status s = add_annotated_joins(drawing, *parts, layers, scene.joins, lines); !s) return s;
  if (Status s = add_annotated_cues(drawing, *parts, scene.cues, lines); !s) return s;
  auto relations = annotated_relations(drawing, *parts);
  if (!relations) return relations.error();
  for (AnnotatedPart& part : *parts) {
    scene.parts.push_back(std::move(part.part));
    result.colors.push_back(std::move(part.colors));
  }
  scene.relations = std::move(*relations);
  turn_joins_from_behind(scene);
  return Done{};
}

constexpr size_t header_size = 33;  ///< of a PNG file
constexpr ImageLimits embedded = {25'000'000, 25'000'000};

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  return c == '/' ? 63 : -1;
}

/// Decodes the first `count` bytes of a base64 text.
Bytes decoded_front(std::string_view text, size_t count) {
  Bytes bytes;
  uint32_t bits = 0;
  int filled = 0;
  for (const char c : text) {
    const int value = base64_value(c);
    if (value < 0 && (c == '=' || bytes.size() == count)) break;
    if (value < 0) continue;
    bits = bits << 6 | static_cast<uint32_t>(value);
    filled += 6;
    if (filled < 8) continue;
    filled -= 8;
    bytes.push_back(static_cast<uint8_t>(bits >> filled & 255));
    if (bytes.size() == count) break;
  }
  return bytes;
}

/// Returns whether an <image> holds, in a data: reference, a PNG file that is not too large to
/// paint, by its header alone.
bool embeds_picture(const pugi::xml_node& image) {
  for (const pugi::xml_attribute& attribute : image.attributes()) {
    if (local_name(attribute.name()) != "href") continue;
    const std::string_view href = trimmed_svg(attribute.value());
    constexpr std::string_view prefix = "data:image/png;base64,";
    if (!href.starts_with(prefix)) return false;
    return png_size(decoded_front(href.substr(prefix.size()), header_size), embedded).ok();
  }
  return false;
}

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

/// Returns whether the element's name is one of SVG: its prefix is looked up; none means SVG unless
/// another namespace is the default. Values that begin with & are entities of the document type,
/// which repair_namespaces replaces.
bool is_svg_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  const size_t colon = name.find(':');
  const bool plain = colon == std::string_view::npos;
  const std::string key = plain ? "xmlns" : "xmlns:" + std::string(name.substr(0, colon));
  for (pugi::xml_node at = element; at; at = at.parent())
    if (const pugi::xml_attribute space = at.attribute(key.c_str()))
      return space.value() == svg_namespace || space.value()[0] == '&';
  return plain;
}

/// Returns whether the renderer may see the element: no script, nothing foreign, nothing from
/// elsewhere, and no picture of unknown size.
bool is_harmless(const pugi::xml_node& element) {
  if (!is_svg_name(element)) return false;
  const std::string_view name = local_name(element.name());
  if (name == "script" || name == "foreignObject" || name == "feImage") return false;
  if (trimmed_svg(element.attribute("data-relievo").value()) == "ignore") return false;
  return name != "image" || embeds_picture(element);
}

void remove_harmful(pugi::xml_node parent) {
  for (pugi::xml_node child = parent.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) {
      if (is_harmless(child)) {
        remove_harmful(child);
      } else {
        parent.remove_child(child);
      }
    }
    child = next;
  }
}

void set_attribute(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) attribute = node.append_attribute(name);
  attribute.set_value(value.c_str());
}

/// Replaces namespaces that are written as entities of the document type.
void repair_namespaces(pugi::xml_node root) {
  for (pugi::xml_attribute attribute : root.attributes()) {
    const std::string_view name = attribute.name();
    if (name.substr(0, 5) != "xmlns" || attribute.value()[0] != '&') continue;
    const std::string_view prefix = local_name(name);
    if (prefix == "xmlns" || prefix == "svg") attribute.set_value(svg_namespace.data());
    if (prefix == "xlink") attribute.set_value("http://www.w3.org/1999/xlink");
  }
  if (local_name(root.name()) == root.name()) {
    set_attribute(root, "xmlns", std::string(svg_namespace));
  }
  set_attribute(root, "xmlns:xlink", "http://www.w3.org/1999/xlink");
}

/// Gives the root our size of the canvas, so that the renderer's positions agree with ours.
void fix_size(pugi::xml_node root, double px_width, double px_height) {
  const std::string width = std::to_string(px_width);
  const std::string height = std::to_string(px_height);
  set_attribute(root, "width", width);
  set_attribute(root, "height", height);
  if (!parse_view_box(root.attribute("viewBox").value())) {
    set_attribute(root, "viewBox", "0 0 " + width + " " + height);
  }
}

/// Makes the document under `root` safe to paint (see PaintableSvg) and returns its text.
std::string paintable_text(pugi::xml_node root, const SvgDrawing& drawing) {
  remove_harmful(root);
  repair_namespaces(root);
  fix_size(root, drawing.px_width, drawing.px_height);
  std::ostringstream text;
  root.print(text, "", pugi::format_raw);
  return text.str();
}

/// Sets the texts of the drawing to paint, without `lines`. Where the drawing's layers may be no
/// parts, the text with these lines is kept too.
void set_paintable(SvgDocument& document, const SvgDrawing& drawing, const Elements& lines,
                   LayeredDrawing& result) {
  if (!result.layers.empty() && !lines.empty()) {
    pugi::xml_document copy;
    copy.reset(document.xml);
    result.text_with_lines = paintable_text(copy.document_element(), drawing);
  }
  for (pugi::xml_node line : lines) set_attribute(line, "data-relievo", "ignore");
  result.paintable = {paintable_text(document.root, drawing), drawing.px_width, drawing.px_height};
}

std::vector<const SvgShape*> shapes_of(const SvgDrawing& drawing) {
  std::vector<const SvgShape*> shapes;
  for (const SvgShape& shape : drawing.shapes) shapes.push_back(&shape);
  return shapes;
}

}  // namespace

Result<LayeredDrawing> read_svg(std::string_view bytes, const SvgOptions& options) {
  const auto document = parse_svg_document(bytes, options);
  if (!document) return document.error();
  const auto drawing = read_drawing(**document, options);
  if (!drawing) return drawing.error();
  LayeredDrawing result;
  result.warnings = drawing->warnings;
  result.scene.width = drawing->width;
  result.scene.height = drawing->height;
  const bool annotated = is_annotated(*drawing);
  const bool declared = annotated || has_notes(*drawing);
  if (!declared) {
    result.marks = opaque_marks(*drawing, shapes_of(*drawing));
    result.layers = marks_by_layer(*drawing);
    if (result.layers.size() < 2) result.layers.clear();
  }
  Elements lines;
  if (declared || !result.layers.empty())
    if (Status status = take_annotations(*drawing, !annotated, result, lines); !status)
      return status.error();
  for (const SvgShape& shape : drawing->shapes)
    if (shape.fill && !shape.is_note())
      result.anchors.insert(result.anchors.end(), shape.anchors.begin(), shape.anchors.end());
  set_paintable(**document, *drawing, lines, result);
  return result;
}

}  // namespace relievo
