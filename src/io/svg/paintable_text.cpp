#include "io/svg/paintable_text.h"

#include <string_view>

#include "io/svg/svg_attributes.h"
#include "io/svg/svg_picture.h"
#include "io/svg/svg_values.h"

namespace relievo {
namespace {

constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";

/// Returns whether the element's name is one of SVG: its prefix is looked up; none means SVG unless
/// another namespace is the default.
bool is_svg_name(const pugi::xml_node& element) {
  const std::string_view name = element.name();
  const size_t colon = name.find(':');
  const bool plain = colon == std::string_view::npos;
  const std::string key = plain ? "xmlns" : "xmlns:" + std::string(name.substr(0, colon));
  for (pugi::xml_node at = element; at; at = at.parent())
    if (const pugi::xml_attribute space = at.attribute(key.c_str()))
      return space.value() == svg_namespace;
  return plain;
}

/// Returns whether the renderer may see the element: no script, nothing foreign, nothing from
/// elsewhere, and no picture of unknown size.
bool is_harmless(const pugi::xml_node& element) {
  if (!is_svg_name(element)) return false;
  const std::string_view name = local_name(element.name());
  if (name == "script" || name == "foreignObject" || name == "feImage") return false;
  if (trimmed_svg(element.attribute("data-relievo").value()) == "ignore") return false;
  return name != "image" || embedded_size(element).ok();
}

/// Renderers believe what a picture's reference says of its type, so that is made true.
void remove_harmful(pugi::xml_node parent) {
  for (pugi::xml_node child = parent.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (child.type() == pugi::node_element) {
      if (is_harmless(child)) {
        if (local_name(child.name()) == "image") state_media_type(child);
        remove_harmful(child);
      } else {
        parent.remove_child(child);
      }
    }
    child = next;
  }
}

/// States the namespaces that a renderer needs.
void state_namespaces(pugi::xml_node root) {
  if (local_name(root.name()) == root.name())
    set_attribute(root, "xmlns", std::string(svg_namespace));
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

/// Collects what pugixml writes.
struct TextWriter : pugi::xml_writer {
  std::string written;

  void write(const void* data, size_t size) override {
    written.append(static_cast<const char*>(data), size);
  }
};

}  // namespace

std::string paintable_text(pugi::xml_node root, double px_width, double px_height) {
  remove_harmful(root);
  state_namespaces(root);
  fix_size(root, px_width, px_height);
  TextWriter text;
  root.print(text, "", pugi::format_raw);
  return text.written;
}

}  // namespace relievo
