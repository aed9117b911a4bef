#include "io/svg/svg_document.h"

#include <algorithm>
#include <initializer_list>

#include "io/svg/basic_shapes.h"
#include "io/svg/resolve_cuts.h"
#include "io/svg/resolve_geometry.h"
#include "io/svg/resolve_styles.h"
#include "io/svg/stylesheet.h"
#include "io/svg/svg_style.h"
#include "io/svg/svg_values.h"
#include "io/svg/xml_text.h"

namespace relievo {
namespace {

Error limit_error(const std::string& what, size_t limit) {
  return {ErrorCode::limit, what + " (limit " + std::to_string(limit) + ")", "svg"};
}

/// Bounds the memory of the parser by counting the characters that start an element or give an
/// attribute its value.
Status check_text(std::string_view text, const SvgOptions& options) {
  const auto tags = std::count(text.begin(), text.end(), '<');
  const auto attributes = std::count(text.begin(), text.end(), '=');
  if (static_cast<size_t>(tags) > 4 * options.max_elements ||
      static_cast<size_t>(attributes) > 30 * options.max_elements) {
    return limit_error("has too many elements", options.max_elements);
  }
  return Done{};
}

/// Returns the file's text in UTF-8, without entities.
Result<std::string> plain_text(std::string_view bytes, const SvgOptions& options,
                               std::vector<std::string>& warnings) {
  if (bytes.size() > options.max_bytes) return limit_error("has too many bytes", options.max_bytes);
  if (bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b') {
    return Error{ErrorCode::bad_input, "is compressed (SVGZ); save it as plain SVG", "svg"};
  }
  auto text = without_entities(utf8_text(bytes, warnings), options.max_bytes, warnings);
  if (!text) return text;
  if (const Status status = check_text(*text, options); !status) return status.error();
  return text;
}

void add_style_element(Stylesheet& sheet, const pugi::xml_node& element) {
  const std::string_view type = element.attribute("type").value();
  if (!type.empty() && type != "text/css") return;
  for (const pugi::xml_node& text : element.children()) add_rules(sheet, text.value());
}

/// Takes the <style> elements below `parent` away and adds their rules to the sheet.
void take_style_elements(pugi::xml_node parent, Stylesheet& sheet) {
  for (pugi::xml_node child = parent.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    if (local_name(child.name()) == "style") {
      add_style_element(sheet, child);
      parent.remove_child(child);
    } else {
      take_style_elements(child, sheet);
    }
    child = next;
  }
}

/// Counts all elements and collects ids. `depth` is that of the children.
Status index_children(SvgDocument& document, const pugi::xml_node& parent, size_t depth,
                      size_t& elements, const SvgOptions& options) {
  if (parent.first_child() && depth > options.max_depth)
    return limit_error("has elements nested too deeply", options.max_depth);
  for (const pugi::xml_node& child : parent.children()) {
    if (child.type() != pugi::node_element) continue;
    if (++elements > options.max_elements)
      return limit_error("has too many elements", options.max_elements);
    const pugi::xml_attribute id = child.attribute("id");
    if (depth > 0 && *id.value() != '\0') document.ids.emplace(id.value(), child);
    if (Status status = index_children(document, child, depth + 1, elements, options); !status)
      return status;
  }
  return Done{};
}

/// Leaves one place where a painter and a reader find what holds for an element: its attributes.
Status resolve(SvgDocument& document, const SvgOptions& options) {
  Stylesheet sheet;
  take_style_elements(document.root, sheet);
  sort_rules(sheet);
  if (Status status = resolve_styles(document, sheet, options); !status) return status;
  if (Status status = resolve_geometry(document); !status) return status;
  if (Status status = resolve_cuts(document, options); !status) return status;
  if (!sheet.fonts.empty()) document.root.append_child("style").text().set(sheet.fonts.c_str());
  document.ids.clear();
  size_t elements = 0;
  return index_children(document, document.xml, 0, elements, options);
}

int line_of(std::string_view bytes, std::ptrdiff_t offset) {
  const auto end = bytes.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(bytes));
  return 1 + static_cast<int>(std::count(bytes.begin(), end, '\n'));
}

/// Returns whether one of the attributes has a value.
bool has_any(const pugi::xml_node& element, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return *element.attribute(name).value() != '\0'; });
}

template <class Test>
bool any_class(const pugi::xml_node& element, const Test& test) {
  std::string_view classes = element.attribute("class").value();
  for (auto item = next_svg_item(classes); !item.empty(); item = next_svg_item(classes)) {
    if (test(item)) return true;
  }
  return false;
}

}  // namespace

Result<std::unique_ptr<SvgDocument>> parse_svg_document(std::string_view bytes,
                                                        const SvgOptions& options) {
  auto document = std::make_unique<SvgDocument>();
  const auto text = plain_text(bytes, options, document->warnings);
  if (!text) return text.error();
  const pugi::xml_parse_result parsed = document->xml.load_buffer(
      text->data(), text->size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    return Error{ErrorCode::bad_input, std::string("is not XML: ") + parsed.description(),
                 "line " + std::to_string(line_of(*text, parsed.offset))};
  }
  size_t elements = 0;
  if (const Status status = index_children(*document, document->xml, 0, elements, options); !status)
    return status.error();
  document->root = document->xml.document_element();
  if (local_name(document->root.name()) != "svg") {
    return Error{ErrorCode::bad_input, "is not SVG: the outermost element must be <svg>", "svg"};
  }
  if (const Status status = resolve(*document, options); !status) return status.error();
  return document;
}

pugi::xml_node referenced_element(const SvgDocument& document, const pugi::xml_node& element) {
  pugi::xml_attribute href = element.attribute("href");
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    if (!href && local_name(attribute.name()) == "href") href = attribute;
  }
  const auto found = document.ids.find(local_reference(href.value()));
  return found == document.ids.end() ? pugi::xml_node() : found->second;
}

pugi::xml_node named_element(const SvgDocument& document, const std::string& id,
                             std::string_view name) {
  const auto found = document.ids.find(id);
  const bool fits = found != document.ids.end() && local_name(found->second.name()) == name;
  return fits ? found->second : pugi::xml_node();
}

SvgMark svg_mark(const pugi::xml_node& element) {
  const std::string_view mark = trimmed_svg(element.attribute("data-relievo").value());
  if (mark == "part") return SvgMark::part;
  if (mark == "texture") return SvgMark::texture;
  if (mark == "ignore") return SvgMark::ignore;
  if (mark == "join") return SvgMark::join;
  return mark == "cue" ? SvgMark::cue : SvgMark::none;
}

bool has_part_values(const pugi::xml_node& element) {
  return has_any(element, {"data-c", "data-d", "data-flat", "data-lean", "data-relation"});
}

bool has_annotation(const pugi::xml_node& element) {
  return svg_mark(element) != SvgMark::none || has_part_values(element) ||
         has_any(element, {"data-upper", "data-lower"}) ||
         !trimmed_svg(element.attribute("data-cue").value()).empty();
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
