#include "io/svg/stylesheet.h"

#include <algorithm>
#include <utility>

#include "io/svg/svg_values.h"
#include "kernel/base/text_rules.h"

namespace relievo {
namespace {

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

/// Returns the position of the first `end` outside quotes and parentheses; the size where there is
/// none.
size_t find_end(std::string_view text, char end) {
  int depth = 0;
  char quote = '\0';
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(') {
      ++depth;
    } else if (c == ')') {
      --depth;
    } else if (c == end && depth <= 0) {
      return i;
    }
  }
  return text.size();
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

/// Returns whether a rule that begins so holds for every screen.
bool is_for_screens(std::string_view at_rule) {
  if (!at_rule.starts_with("@media")) return false;
  at_rule = trimmed_svg(at_rule.substr(6));
  return at_rule == "all" || at_rule == "screen" || at_rule == "only screen";
}

void add_rule(Stylesheet& sheet, std::string_view selectors, std::string_view body) {
  const auto declarations =
      std::make_shared<const std::vector<Declaration>>(parse_declarations(body));
  while (!selectors.empty() && sheet.rules.size() <= max_style_rules) {
    const size_t comma = find_end(selectors, ',');
    Selector selector = parse_selector(selectors.substr(0, comma));
    selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    if (selector.empty()) continue;
    const int weight = specificity(selector);
    sheet.rules.push_back({std::move(selector), weight, declarations});
  }
}

/// Adds the rules of a sheet without comments; `outer` of one that may have at-rules.
void add_clean_rules(Stylesheet& sheet, std::string_view text, bool outer) {
  std::string_view rest = trimmed_svg(text);
  while (!rest.empty()) {
    const size_t open = rest.find('{');
    if (rest.front() == '@' && rest.find(';') < open) {
      rest = trimmed_svg(rest.substr(rest.find(';') + 1));
      continue;
    }
    if (open == std::string_view::npos) return;
    const size_t end = block_end(rest, open);
    const std::string_view head = trimmed_svg(rest.substr(0, open));
    const std::string_view body = rest.substr(open + 1, end - open - 2);
    if (head.starts_with("@font-face")) sheet.fonts.append(rest.substr(0, end));
    if (outer && is_for_screens(head)) add_clean_rules(sheet, body, false);
    if (!head.starts_with("@")) add_rule(sheet, head, body);
    rest = trimmed_svg(rest.substr(end));
  }
}

}  // namespace

std::vector<Declaration> parse_declarations(std::string_view text) {
  const std::string clean = without_comments(text);
  std::string_view rest = clean;
  std::vector<Declaration> list;
  while (!rest.empty()) {
    const size_t end = find_end(rest, ';');
    const std::string_view item = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const size_t colon = item.find(':');
    if (colon == std::string_view::npos) continue;
    Declaration d{std::string(trimmed_svg(item.substr(0, colon))), "", false};
    if (!d.is_custom()) d.name = lower_case(d.name);
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
  add_clean_rules(sheet, without_comments(text), true);
}

void sort_rules(Stylesheet& sheet) {
  std::stable_sort(
      sheet.rules.begin(), sheet.rules.end(),
      [](const StyleRule& p, const StyleRule& q) { return p.specificity < q.specificity; });
}

}  // namespace relievo
