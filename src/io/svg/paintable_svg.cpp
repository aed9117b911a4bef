#include "io/svg/paintable_svg.h"

#include <cstdint>
#include <utility>

#include "io/svg/embedded_image.h"
#include "io/svg/interpret_svg.h"
#include "io/svg/scanner.h"
#include "io/svg/svg_viewport.h"

namespace relievo {
namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

/// Whether the name belongs to SVG: prefixes are looked up, none means SVG unless another namespace
/// is the default. Values that begin with & are entities of the document type, which are repaired.
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

/// Whether the renderer may see the element: no scripts, nothing foreign, nothing from elsewhere,
/// and no picture of unknown size.
bool is_harmless(const pugi::xml_node& element) {
  if (!is_svg_name(element)) return false;
  const std::string_view name = local_name(element.name());
  if (name == "script" || name == "foreignObject" || name == "feImage") return false;
  if (trimmed_svg(element.attribute("data-relievo").value()) == "ignore") return false;
  if (name != "image") return true;
  const auto size = embedded_png_size(element);
  return size && static_cast<int64_t>(size->width) * size->height <= 25000000;
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

/// Namespaces that were written as entities of the document type are put in their place.
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

/// Gives the root the size that the canvas has for us, so that both agree on where things are.
void fix_size(pugi::xml_node root, const SvgCanvas& canvas) {
  const std::string width = std::to_string(canvas.px_width);
  const std::string height = std::to_string(canvas.px_height);
  set_attribute(root, "width", width);
  set_attribute(root, "height", height);
  if (!parse_view_box(root.attribute("viewBox").value())) {
    set_attribute(root, "viewBox", "0 0 " + width + " " + height);
  }
}

struct StringWriter : pugi::xml_writer {
  std::string text;
  void write(const void* data, size_t size) override {
    text.append(static_cast<const char*>(data), size);
  }
};

}  // namespace

Result<PaintableSvg> paintable_svg(std::string_view bytes, const SvgOptions& options) {
  auto parsed = parse_svg_document(bytes, options);
  if (!parsed) return parsed.error();
  SvgDocument& document = **parsed;
  const auto canvas = canvas_of(document, options);
  if (!canvas) return canvas.error();
  const auto drawing = read_drawing(document, options);
  if (!drawing) return drawing.error();
  const auto interpretation = interpret_svg(*drawing, options);
  if (!interpretation) return interpretation.error();
  for (pugi::xml_node note : interpretation->note_elements) {
    set_attribute(note, "data-relievo", "ignore");
  }
  remove_harmful(document.root);
  repair_namespaces(document.root);
  fix_size(document.root, *canvas);
  StringWriter writer;
  document.root.print(writer, "", pugi::format_raw);
  return PaintableSvg{std::move(writer.text), canvas->px_width, canvas->px_height};
}

}  // namespace relievo
