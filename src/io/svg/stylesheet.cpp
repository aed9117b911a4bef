#include "io/svg/stylesheet.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "io/svg/svg_values.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

bool is_name_char(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || (c & 0x80);
}

std::string take_name(std::string_view& text) {
  size_t n = 0;
  while (n < text.size() && is_name_char(text[n])) ++n;
  std::string name(text.substr(0, n));
  text.remove_prefix(n);
  return name;
}

std::string without_comments(std::string_view text) {
  std::string result;
  for (size_t i = 0; i < text.size();) {
    const size_t open = std::min(text.find("/*", i), text.size());
    result.append(text.substr(i, open - i));
    if (open == text.size()) break;
    const size_t close = text.find("*/", open + 2);
    if (close == std::string_view::npos) break;
    i = close + 2;
  }
  return result;
}

std::string unquoted(std::string_view text) {
  text = trimmed_svg(text);
  if (text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0]) {
    text = text.substr(1, text.size() - 2);
  }
  return std::string(text);
}

std::optional<CompoundSelector::Attribute> attribute_condition(std::string_view inside) {
  CompoundSelector::Attribute condition;
  const size_t equals = inside.find('=');
  condition.name = std::string(trimmed_svg(inside.substr(0, equals)));
  if (equals == std::string_view::npos) return condition;
  condition.value = unquoted(inside.substr(equals + 1));
  condition.match = '=';
  if (!condition.name.empty() && !is_name_char(condition.name.back())) {
    condition.match = condition.name.back();
    condition.name.pop_back();
  }
  if (condition.match == '|') return std::nullopt;
  return condition;
}

/// Takes one condition (".a", "#b", "[c=d]", ":first-child") from the front of `text`.
bool take_condition(std::string_view& text, CompoundSelector& compound) {
  const char kind = text.front();
  text.remove_prefix(1);
  if (kind == '.') {
    compound.classes.push_back(take_name(text));
    return !compound.classes.back().empty();
  }
  if (kind == '#') {
    compound.id = take_name(text);
    return !compound.id.empty();
  }
  if (kind == ':') {
    compound.first_child = take_name(text) == "first-child";
    return compound.first_child;
  }
  const size_t close = text.find(']');
  if (kind != '[' || close == std::string_view::npos) return false;
  const auto condition = attribute_condition(text.substr(0, close));
  text.remove_prefix(close + 1);
  if (condition) compound.attributes.push_back(*condition);
  return condition.has_value();
}

std::optional<CompoundSelector> take_compound(std::string_view& text) {
  CompoundSelector compound;
  bool any = false;
  if (text.front() == '*') {
    text.remove_prefix(1);
    any = true;
  } else if (is_name_char(text.front())) {
    compound.type = take_name(text);
    any = true;
  }
  while (!text.empty() && std::string_view(".#:[").find(text.front()) != std::string_view::npos) {
    if (!take_condition(text, compound)) return std::nullopt;
    any = true;
  }
  if (!any) return std::nullopt;
  return compound;
}

std::vector<CompoundSelector> parse_selector(std::string_view text) {
  std::vector<CompoundSelector> chain;
  bool child = false;
  for (text = trimmed_svg(text); !text.empty(); text = trimmed_svg(text)) {
    if (text.front() == '>') {
      if (chain.empty() || child) return {};
      child = true;
      text.remove_prefix(1);
      continue;
    }
    auto compound = take_compound(text);
    if (!compound) return {};
    compound->child_of_previous = child;
    child = false;
    chain.push_back(std::move(*compound));
  }
  if (child) return {};
  return chain;
}

int specificity(const std::vector<CompoundSelector>& chain) {
  int ids = 0;
  int classes = 0;
  int types = 0;
  for (const CompoundSelector& c : chain) {
    ids += c.id.empty() ? 0 : 1;
    classes += static_cast<int>(c.classes.size() + c.attributes.size()) + (c.first_child ? 1 : 0);
    types += c.type.empty() ? 0 : 1;
  }
  return 1000000 * std::min(ids, 999) + 1000 * std::min(classes, 999) + std::min(types, 999);
}

/// Returns the position after the block that opens at `open`, or the end of the text.
size_t block_end(std::string_view text, size_t open) {
  int depth = 0;
  for (size_t i = open; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i + 1;
  }
  return text.size();
}

bool has_word(std::string_view list, std::string_view word) {
  for (std::string_view item = next_svg_item(list); !item.empty(); item = next_svg_item(list)) {
    if (item == word) return true;
  }
  return false;
}

bool holds(const CompoundSelector::Attribute& condition, const pugi::xml_node& element) {
  const pugi::xml_attribute attribute = element.attribute(condition.name.c_str());
  if (!attribute) return false;
  const std::string_view value = attribute.value();
  const std::string_view wanted = condition.value;
  switch (condition.match) {
    case '\0':
      return true;
    case '=':
      return value == wanted;
    case '~':
      return has_word(value, wanted);
    case '^':
      return !wanted.empty() && value.starts_with(wanted);
    case '$':
      return !wanted.empty() && value.ends_with(wanted);
    case '*':
      return !wanted.empty() && value.find(wanted) != std::string_view::npos;
    default:
      return false;
  }
}

bool is_first_child(const pugi::xml_node& element) {
  for (auto n = element.previous_sibling(); n; n = n.previous_sibling()) {
    if (n.type() == pugi::node_element) return false;
  }
  return true;
}

bool matches_compound(const CompoundSelector& c, const pugi::xml_node& element) {
  if (!c.type.empty() && local_name(element.name()) != c.type) return false;
  if (!c.id.empty() && element.attribute("id").value() != c.id) return false;
  if (c.first_child && !is_first_child(element)) return false;
  const std::string_view classes = element.attribute("class").value();
  return std::all_of(c.classes.begin(), c.classes.end(),
                     [&](const std::string& name) { return has_word(classes, name); }) &&
         std::all_of(c.attributes.begin(), c.attributes.end(),
                     [&](const CompoundSelector::Attribute& a) { return holds(a, element); });
}

}  // namespace

std::vector<Declaration> parse_declarations(std::string_view text) {
  const std::string clean = without_comments(text);
  std::string_view rest = clean;
  std::vector<Declaration> list;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view item = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const size_t colon = item.find(':');
    if (colon == std::string_view::npos) continue;
    Declaration d{lower_case(trimmed_svg(item.substr(0, colon))), "", false};
    std::string_view value = trimmed_svg(item.substr(colon + 1));
    const size_t bang = value.find('!');
    if (bang != std::string_view::npos) {
      d.important = trimmed_svg(value.substr(bang + 1)) == "important";
      value = trimmed_svg(value.substr(0, bang));
    }
    d.value = std::string(value);
    list.push_back(std::move(d));
  }
  return list;
}

void add_rules(Stylesheet& sheet, std::string_view text) {
  const std::string clean = without_comments(text);
  std::string_view rest = trimmed_svg(clean);
  while (!rest.empty()) {
    const size_t open = rest.find('{');
    if (rest.front() == '@' && rest.find(';') < open) {
      rest = trimmed_svg(rest.substr(rest.find(';') + 1));
      continue;
    }
    if (open == std::string_view::npos) return;
    const size_t end = block_end(rest, open);
    std::string_view selectors = rest.substr(0, open);
    const std::string_view body = rest.substr(open + 1, end - open - 2);
    const bool at_rule = rest.front() == '@';
    rest = trimmed_svg(rest.substr(end));
    if (at_rule) continue;
    while (!selectors.empty()) {
      const size_t comma = std::min(selectors.find(','), selectors.size());
      auto chain = parse_selector(selectors.substr(0, comma));
      selectors.remove_prefix(std::min(comma + 1, selectors.size()));
      if (chain.empty()) continue;
      const int weight = specificity(chain);
      sheet.push_back({std::move(chain), weight, parse_declarations(body)});
    }
  }
}

void sort_rules(Stylesheet& sheet) {
  std::stable_sort(sheet.begin(), sheet.end(), [](const StyleRule& p, const StyleRule& q) {
    return p.specificity < q.specificity;
  });
}

bool matches(const StyleRule& rule, const pugi::xml_node& element) {
  pugi::xml_node node = element;
  if (!matches_compound(rule.selector.back(), node)) return false;
  for (size_t i = rule.selector.size() - 1; i-- > 0;) {
    const bool direct = rule.selector[i + 1].child_of_previous;
    node = node.parent();
    while (!direct && node && !matches_compound(rule.selector[i], node)) node = node.parent();
    if (!node || !matches_compound(rule.selector[i], node)) return false;
  }
  return true;
}

std::string_view local_name(std::string_view name) {
  const size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace relievo
