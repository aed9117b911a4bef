#include "io/svg/svg_document.h"

#include <algorithm>

#include "io/svg/stylesheet.h"
#include "io/svg/svg_style.h"

namespace relievo {
namespace {

Error limit_error(const std::string& what, size_t limit) {
  return {ErrorCode::limit, what + " (limit " + std::to_string(limit) + ")", "svg"};
}

/// Bounds what the parser may allocate from the number of characters that start an element or
/// give an attribute its value.
Status check_bytes(std::string_view bytes, const SvgOptions& options) {
  if (bytes.size() > options.max_bytes) return limit_error("file too large", options.max_bytes);
  if (bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b') {
    return Error{ErrorCode::bad_input, "compressed SVG: save it as plain SVG", "svg"};
  }
  const auto tags = std::count(bytes.begin(), bytes.end(), '<');
  const auto attributes = std::count(bytes.begin(), bytes.end(), '=');
  if (static_cast<size_t>(tags) > 4 * options.max_elements ||
      static_cast<size_t>(attributes) > 30 * options.max_elements) {
    return limit_error("too many elements", options.max_elements);
  }
  return Done{};
}

Status check_nesting(const pugi::xml_document& xml, const SvgOptions& options) {
  size_t depth = 0;
  size_t elements = 0;
  pugi::xml_node node = xml.first_child();
  while (node) {
    if (node.type() == pugi::node_element && ++elements > options.max_elements) {
      return limit_error("too many elements", options.max_elements);
    }
    if (node.first_child()) {
      if (++depth > options.max_depth) {
        return limit_error("elements nested too deeply", options.max_depth);
      }
      node = node.first_child();
      continue;
    }
    while (node && !node.next_sibling()) {
      node = node.parent();
      if (depth > 0) --depth;
    }
    node = node.next_sibling();
  }
  return Done{};
}

void collect_ids(SvgDocument& document, const pugi::xml_node& parent) {
  for (const pugi::xml_node& child : parent.children()) {
    const pugi::xml_attribute id = child.attribute("id");
    if (*id.value() != '\0') document.ids.emplace(id.value(), child);
    collect_ids(document, child);
  }
}

int line_of(std::string_view bytes, std::ptrdiff_t offset) {
  const auto end = bytes.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(bytes));
  return 1 + static_cast<int>(std::count(bytes.begin(), end, '\n'));
}

}  // namespace

Result<std::unique_ptr<SvgDocument>> parse_svg_document(std::string_view bytes,
                                                        const SvgOptions& options) {
  if (const Status status = check_bytes(bytes, options); !status) return status.error();
  auto document = std::make_unique<SvgDocument>();
  const pugi::xml_parse_result parsed = document->xml.load_buffer(bytes.data(), bytes.size());
  if (!parsed) {
    return Error{ErrorCode::bad_input, std::string("not XML: ") + parsed.description(),
                 "line " + std::to_string(line_of(bytes, parsed.offset))};
  }
  if (const Status status = check_nesting(document->xml, options); !status) return status.error();
  document->root = document->xml.document_element();
  if (local_name(document->root.name()) != "svg") {
    return Error{ErrorCode::bad_input, "the outermost element is not <svg>", "svg"};
  }
  if (bytes.find("<!ENTITY") != std::string_view::npos) {
    document->warnings.push_back("entities of the document type are not expanded");
  }
  collect_ids(*document, document->root);
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

}  // namespace relievo
