#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// "name: value" of CSS, the name in lower case.
struct Declaration {
  std::string name;
  std::string value;
  bool important = false;
};

std::vector<Declaration> parse_declarations(std::string_view text);

/// One compound selector: every given condition must hold.
struct CompoundSelector {
  struct Attribute {
    std::string name;
    std::string value;
    char match = '\0';  ///< '\0' present, '=' equal, '~' one of the words, '^' '$' '*' part of it
  };
  std::string type;  ///< element name; empty: any
  std::string id;
  std::vector<std::string> classes;
  std::vector<Attribute> attributes;
  bool first_child = false;
  bool child_of_previous = false;  ///< ">" before it; otherwise any ancestor will do
};

struct StyleRule {
  std::vector<CompoundSelector> selector;  ///< outermost ancestor first
  int specificity = 0;
  std::vector<Declaration> declarations;
};

/// The rules of all <style> elements, least specific first, in document order among equals.
struct Stylesheet {
  std::vector<StyleRule> rules;
};

/// Adds the rules of one sheet. At-rules, pseudo-classes other than :first-child and sibling
/// combinators are left out with all that depends on them; nothing is ever imported.
void add_rules(Stylesheet& sheet, std::string_view text);

/// Puts the rules in order of specificity; to be called once after all sheets were added.
void sort_rules(Stylesheet& sheet);

bool matches(const StyleRule& rule, const pugi::xml_node& element);

/// Element or attribute name without its namespace prefix.
std::string_view local_name(std::string_view name);

}  // namespace relievo
