#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/svg/css_selector.h"

namespace relievo {

/// A declaration of CSS, "name: value", with the name in lower case but for custom properties.
struct Declaration {
  std::string name;
  std::string value;
  bool important = false;

  bool is_custom() const { return name.starts_with("--"); }
};

struct StyleRule {
  Selector selector;
  int specificity = 0;
  std::shared_ptr<const std::vector<Declaration>> declarations;
};

/// A sheet with more is not read to its end.
constexpr size_t max_style_rules = 100'000;

/// The content of all <style> elements.
struct Stylesheet {
  std::vector<StyleRule> rules;  ///< least specific first, in document order among equals
  std::string fonts;             ///< all @font-face rules
};

/// Reads "name: value; ..." of a rule's block or a style attribute.
std::vector<Declaration> parse_declarations(std::string_view text);

/// Adds the rules of one sheet, those for screens included. Leaves out other at-rules, and rules
/// whose selector cannot be read; nothing is ever imported.
void add_rules(Stylesheet& sheet, std::string_view text);

/// Sorts the rules by specificity; call it once, after all sheets are added.
void sort_rules(Stylesheet& sheet);

}  // namespace relievo
