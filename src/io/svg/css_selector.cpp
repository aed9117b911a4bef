#include "io/svg/css_selector.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

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

/// Reads "odd", "even", "3", "-n+3" or "2n + 1".
std::optional<SiblingPlace> counted_place(std::string_view text) {
  const std::string word = lower_case(trimmed_svg(text));
  if (word == "odd") return SiblingPlace{2, 1};
  if (word == "even") return SiblingPlace{2, 0};
  const auto number = [](SvgScanner& scanner) -> std::optional<int> {
    const auto value = scanner.number();
    if (!value || !(std::abs(*value) < 1e6)) return std::nullopt;
    return static_cast<int>(*value);
  };
  const size_t n = word.find('n');
  SvgScanner first(std::string_view(word).substr(0, n));
  if (n == std::string::npos) {
    const auto b = number(first);
    return b && first.at_end() ? std::optional(SiblingPlace{0, *b}) : std::nullopt;
  }
  const std::string before = word.substr(0, n);
  const bool is_sign = before.empty() || before == "+" || before == "-";
  const std::optional<int> a = is_sign ? (before == "-" ? -1 : 1) : number(first);
  std::string after = word.substr(n + 1);
  after.erase(std::remove(after.begin(), after.end(), ' '), after.end());
  SvgScanner last(after);
  const std::optional<int> b = after.empty() ? 0 : number(last);
  if (!a || !b || (!after.empty() && !last.at_end())) return std::nullopt;
  return SiblingPlace{*a, *b};
}

std::optional<CompoundSelector> take_compound(std::string_view& text);

/// Takes "(...)" from the front of `text` and returns what is inside; nothing where it never ends.
std::optional<std::string_view> take_parenthesis(std::string_view& text) {
  const size_t close = text.find(')');
  if (text.empty() || text[0] != '(' || close == std::string_view::npos) return std::nullopt;
  const std::string_view inside = text.substr(1, close - 1);
  text.remove_prefix(close + 1);
  return inside;
}

bool take_exclusions(std::string_view& text, CompoundSelector& compound) {
  auto inside = take_parenthesis(text);
  if (!inside) return false;
  while (!inside->empty()) {
    *inside = trimmed_svg(*inside);
    if (inside->empty()) return false;
    auto excluded = take_compound(*inside);
    *inside = trimmed_svg(*inside);
    if (!excluded || (!inside->empty() && inside->front() != ',')) return false;
    if (!inside->empty()) inside->remove_prefix(1);
    compound.excluded.push_back(std::move(*excluded));
  }
  return !compound.excluded.empty();
}

/// Takes the pseudo-class after a colon.
bool take_pseudo_class(std::string_view& text, CompoundSelector& compound) {
  const std::string name = lower_case(take_name(text));
  if (name == "root") return compound.root = true;
  if (name == "not") return take_exclusions(text, compound);
  const bool of_type = name.ends_with("-of-type");
  const bool first = name.starts_with("first-");
  const bool last = name.starts_with("last-");
  const bool only = name.starts_with("only-");
  if (!of_type && !name.ends_with("-child")) return false;
  if (first || only) compound.places.push_back({0, 1, false, of_type});
  if (last || only) compound.places.push_back({0, 1, true, of_type});
  if (first || last || only) return true;
  const bool from_end = name.starts_with("nth-last-");
  if (!from_end && name != "nth-child" && name != "nth-of-type") return false;
  const auto inside = take_parenthesis(text);
  const auto place = inside ? counted_place(*inside) : std::nullopt;
  if (place) compound.places.push_back({place->a, place->b, from_end, of_type});
  return place.has_value();
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
  if (kind == ':') return take_pseudo_class(text, compound);
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

pugi::xml_node sibling(const pugi::xml_node& element, bool after) {
  pugi::xml_node next = after ? element.next_sibling() : element.previous_sibling();
  while (next && next.type() != pugi::node_element)
    next = after ? next.next_sibling() : next.previous_sibling();
  return next;
}

bool is_at(const SiblingPlace& place, const pugi::xml_node& element, size_t& work) {
  int count = 1;
  for (pugi::xml_node other = sibling(element, place.from_end); other && work < max_selector_work;
       other = sibling(other, place.from_end), ++work) {
    if (!place.of_type || std::string_view(other.name()) == element.name()) ++count;
    if (place.a == 0 && count > place.b) return false;
  }
  const int rest = count - place.b;
  if (place.a == 0) return rest == 0;
  return rest % place.a == 0 && rest / place.a >= 0;
}

bool matches_compound(const CompoundSelector& c, const pugi::xml_node& element, size_t& work) {
  if (++work > max_selector_work) return false;
  if (!c.type.empty() && local_name(element.name()) != c.type) return false;
  if (!c.id.empty() && element.attribute("id").value() != c.id) return false;
  if (c.root && element.parent().type() != pugi::node_document) return false;
  const std::string_view classes = element.attribute("class").value();
  return std::all_of(c.classes.begin(), c.classes.end(),
                     [&](const std::string& name) { return has_word(classes, name); }) &&
         std::all_of(c.attributes.begin(), c.attributes.end(),
                     [&](const CompoundSelector::Attribute& a) { return holds(a, element); }) &&
         std::all_of(c.places.begin(), c.places.end(),
                     [&](const SiblingPlace& place) { return is_at(place, element, work); }) &&
         std::none_of(c.excluded.begin(), c.excluded.end(), [&](const CompoundSelector& other) {
           return matches_compound(other, element, work);
         });
}

constexpr size_t max_compounds = 32;  ///< of a selector

/// Returns whether the first `count` compounds match, the last of them the element.
bool matches_chain(const Selector& selector, size_t count, pugi::xml_node element, size_t& work) {
  if (element.type() != pugi::node_element || !matches_compound(selector[count - 1], element, work))
    return false;
  if (count == 1) return true;
  const char combinator = selector[count - 1].combinator;
  const bool beside = combinator == '+' || combinator == '~';
  const bool anywhere = combinator == ' ' || combinator == '~';
  do {
    element = beside ? sibling(element, false) : element.parent();
    if (matches_chain(selector, count - 1, element, work)) return true;
  } while (anywhere && element && work < max_selector_work);
  return false;
}

int clamped_sum(int ids, int classes, int types) {
  return 1000000 * std::min(ids, 999) + 1000 * std::min(classes, 999) + std::min(types, 999);
}

int specificity_of(const CompoundSelector& c) {
  int most = 0;
  for (const CompoundSelector& other : c.excluded) most = std::max(most, specificity_of(other));
  const size_t classes =
      c.classes.size() + c.attributes.size() + c.places.size() + (c.root ? 1 : 0);
  return most +
         clamped_sum(c.id.empty() ? 0 : 1, static_cast<int>(classes), c.type.empty() ? 0 : 1);
}

}  // namespace

Selector parse_selector(std::string_view text) {
  Selector chain;
  char combinator = ' ';
  for (text = trimmed_svg(text); !text.empty(); text = trimmed_svg(text)) {
    const char c = text.front();
    if (c == '>' || c == '+' || c == '~') {
      if (chain.empty() || combinator != ' ') return {};
      combinator = c;
      text.remove_prefix(1);
      continue;
    }
    auto compound = take_compound(text);
    if (!compound) return {};
    compound->combinator = std::exchange(combinator, ' ');
    chain.push_back(std::move(*compound));
  }
  if (combinator != ' ' || chain.size() > max_compounds) return {};
  return chain;
}

int specificity(const Selector& selector) {
  int sum = 0;
  for (const CompoundSelector& compound : selector)
    sum = std::min(sum + specificity_of(compound), 1'000'000'000);
  return sum;
}

bool matches(const Selector& selector, const pugi::xml_node& element, size_t& work) {
  return matches_chain(selector, selector.size(), element, work);
}

}  // namespace relievo
