#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// A place among siblings that CSS counts as a n + b, n from 0 on.
struct SiblingPlace {
  int a = 0;
  int b = 1;
  bool from_end = false;
  bool of_type = false;  ///< only siblings of the same name count
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
  std::vector<SiblingPlace> places;
  std::vector<CompoundSelector> excluded;  ///< by :not
  bool root = false;                       ///< only the outermost element
  /// Relation of the previous selector to it: ' ' an ancestor, '>' the parent, '+' the sibling
  /// before it, '~' any sibling before it.
  char combinator = ' ';
};

/// A chain of compound selectors, the element's own last.
using Selector = std::vector<CompoundSelector>;

/// Reads a selector; empty where it is malformed, has more than 32 compounds, or has a pseudo-class
/// other than :root, :not and those that count siblings. States such as :hover never hold in a
/// picture.
Selector parse_selector(std::string_view text);

/// Returns the weight of a selector among others: ids, then classes, then types.
int specificity(const Selector& selector);

/// Returns whether the selector matches the element. Adds the number of elements looked at to
/// `work`, and gives up beyond `max_selector_work`.
bool matches(const Selector& selector, const pugi::xml_node& element, size_t& work);

/// Elements that the selectors of a file may look at, all together.
constexpr size_t max_selector_work = 200'000'000;

}  // namespace relievo
