#pragma once

#include <string>
#include <vector>

namespace relievo::house {

/// The names that a source file declares or defines at namespace scope, outside anonymous
/// namespaces. Files are formatted by clang-format, so such a declaration begins in column 0.
struct Names {
  std::vector<std::string> types;      ///< structs, classes, enumerations, unions
  std::vector<std::string> constants;  ///< constexpr values
  std::vector<std::string> functions;  ///< functions with a body, without members
};

Names names_of(const std::string& text);

/// Counts the types that a file declares anywhere, in anonymous namespaces and classes too.
int type_count(const std::string& text);

/// Counts the numbers that a file names as constants, in anonymous namespaces too.
int constant_count(const std::string& text);

/// Checks whether `text` declares a function called `name`.
bool declares(const std::string& text, const std::string& name);

}  // namespace relievo::house
