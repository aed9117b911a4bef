#include "io/svg/svg_attributes.h"

#include "io/svg/svg_values.h"
#include "io/svg/svg_viewport.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

std::string style_text(const std::vector<Declaration>& declarations) {
  std::string text;
  for (const Declaration& d : declarations) text += d.name + ":" + d.value + ";";
  return text;
}

size_t forget_ids(pugi::xml_node element) {
  size_t count = 1;
  element.remove_attribute("id");
  for (pugi::xml_node child : element.children())
    if (child.type() == pugi::node_element) count += forget_ids(child);
  return count;
}

void visit_below(pugi::xml_node parent, const LengthContext& lengths,
                 const std::function<void(pugi::xml_node, const LengthContext&)>& visit) {
  for (pugi::xml_node child = parent.first_child(); child; child = child.next_sibling()) {
    if (child.type() != pugi::node_element) continue;
    LengthContext own = lengths;
    const auto font_size =
        parse_length(stated_value(child, "font-size"), LengthAxis::vertical, lengths);
    if (font_size && *font_size > 0) own.font_size = *font_size;
    LengthContext inside = own;
    const std::string_view name = local_name(child.name());
    if (name == "symbol" || name == "svg")
      enter_viewport(child, viewport_of(child, child, own), inside);
    visit_below(child, inside, visit);
    visit(child, own);
  }
}

}  // namespace

std::string stated_value(const pugi::xml_node& element, std::string_view name) {
  const auto own = parse_declarations(element.attribute("style").value());
  for (size_t i = own.size(); i-- > 0;)
    if (own[i].name == name) return own[i].value;
  return element.attribute(std::string(name).c_str()).value();
}

void set_attribute(pugi::xml_node node, const char* name, const std::string& value) {
  pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) attribute = node.append_attribute(name);
  attribute.set_value(value.c_str());
}

void set_style(pugi::xml_node element, const std::vector<Declaration>& declarations) {
  if (declarations.empty())
    element.remove_attribute("style");
  else
    set_attribute(element, "style", style_text(declarations));
}

pugi::xml_node wrap_children(pugi::xml_node element) {
  const std::string_view name = element.name();
  const std::string prefix(name.substr(0, name.size() - local_name(name).size()));
  pugi::xml_node group = element.prepend_child((prefix + "g").c_str());
  while (pugi::xml_node child = group.next_sibling()) group.append_move(child);
  return group;
}

size_t rename_copy(pugi::xml_node copy, SvgDocument& document) {
  const size_t count = forget_ids(copy);
  const std::string id =
      free_name("copy-" + std::to_string(document.ids.size()),
                [&](const std::string& name) { return document.ids.count(name) != 0; });
  document.ids.emplace(id, copy);
  set_attribute(copy, "id", id);
  return count;
}

void visit_elements(const SvgDocument& document,
                    const std::function<void(pugi::xml_node, const LengthContext&)>& visit) {
  LengthContext lengths;
  if (const auto size = root_size(document.root)) enter_viewport(document.root, *size, lengths);
  visit_below(document.root, lengths, visit);
}

}  // namespace relievo
