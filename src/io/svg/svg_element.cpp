#include "io/svg/svg_element.h"

#include "io/svg/basic_shapes.h"
#include "io/svg/scanner.h"

namespace relievo {

namespace {

template <class Test>
bool any_class(const pugi::xml_node& element, const Test& test) {
  std::string_view classes = element.attribute("class").value();
  for (auto item = next_svg_item(classes); !item.empty(); item = next_svg_item(classes)) {
    if (test(item)) return true;
  }
  return false;
}

}  // namespace

SvgAnnotation annotation_of(const pugi::xml_node& element) {
  SvgAnnotation a;
  const std::string_view mark = trimmed_svg(element.attribute("data-relievo").value());
  if (mark == "part") a.mark = SvgMark::part;
  if (mark == "texture") a.mark = SvgMark::texture;
  if (mark == "ignore") a.mark = SvgMark::ignore;
  if (mark == "join") a.mark = SvgMark::join;
  if (mark == "cue") a.mark = SvgMark::cue;
  a.c = element.attribute("data-c").value();
  a.d = element.attribute("data-d").value();
  a.flat = element.attribute("data-flat").value();
  a.lean = element.attribute("data-lean").value();
  a.relation = element.attribute("data-relation").value();
  a.upper = element.attribute("data-upper").value();
  a.lower = element.attribute("data-lower").value();
  a.cue = trimmed_svg(element.attribute("data-cue").value());
  a.value = element.attribute("data-value").value();
  a.part = element.attribute("data-part").value();
  return a;
}

std::string name_of(const pugi::xml_node& element) {
  const pugi::xml_attribute label = element.attribute("inkscape:label");
  return *label.value() != '\0' ? label.value() : element.attribute("id").value();
}

bool has_join_class(const pugi::xml_node& element) {
  return any_class(element, [](std::string_view item) { return item.substr(0, 4) == "join"; });
}

bool has_cue_class(const pugi::xml_node& element) {
  return any_class(element, [](std::string_view item) { return item == "cue"; });
}

bool is_container(std::string_view name) {
  return name == "g" || name == "a" || name == "svg" || name == "switch";
}

bool switch_allows(const pugi::xml_node& child) {
  const std::string_view name = local_name(child.name());
  if (!is_shape_element(name) && !is_container(name) && name != "use") return false;
  if (child.attribute("requiredExtensions")) return false;
  const pugi::xml_attribute language = child.attribute("systemLanguage");
  if (!language) return true;
  std::string_view list = language.value();
  for (auto item = next_svg_item(list); !item.empty(); item = next_svg_item(list)) {
    if (item == "en" || item.substr(0, 3) == "en-") return true;
  }
  return false;
}

bool is_blur(const SvgDocument& document, const std::string& filter) {
  const auto found = document.ids.find(filter);
  return found != document.ids.end() &&
         local_name(found->second.last_child().name()) == "feGaussianBlur";
}

}  // namespace relievo
