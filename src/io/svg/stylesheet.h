#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// A declaration of CSS, "name: value", with the name in lower case.
struct Declaration {
  std::string name;
  std::string value;
  bool important = false;
};

/// A compound selector: all of its conditions must hold.
struct CompoundSelector {
  struct Attribute {
    std::string name;
    std::string value;
    char match = '\0';  ///< '\0' present, '=' equal, '~' one word, '^' start, '$' end, '*' part
  };
  std::string type;  ///< element name; empty: any
  std::string id;
  std::vector<std::string> classes;
  std::vector<Attribute> attributes;
  bool first_child = false;
  bool child_of_previous = false;  ///< ">" stands before it; else the previous is any ancestor
};

struct StyleRule {
  std::vector<CompoundSelector> selector;  ///< outermost ancestor first
  int specificity = 0;
  std::vector<Declaration> declarations;
};

/// The rules of all <style> elements, least specific first, in document order among equals.
using Stylesheet = std::vector<StyleRule>;

/// Reads "name: value; ..." of a rule's block or a style attribute.
std::vector<Declaration> parse_declarations(std::string_view text);

/// Adds the rules of one sheet. Leaves out at-rules, and rules with pseudo-classes other than
/// :first-child or with sibling combinators; nothing is ever imported.
void add_rules(Stylesheet& sheet, std::string_view text);

/// Sorts the rules by specificity; call it once, after all sheets are added.
void sort_rules(Stylesheet& sheet);

/// Returns whether the rule's selector matches the element.
bool matches(const StyleRule& rule, const pugi::xml_node& element);

/// Returns the name of an element or attribute without its namespace prefix.
std::string_view local_name(std::string_view name);

}  // namespace relievo
