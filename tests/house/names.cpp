#include "house/names.h"

#include <regex>
#include <sstream>

namespace relievo::house {
namespace {

const std::regex type_pattern(
    R"(^(?:template <.*>\s*)?(?:struct|class|enum class|enum|union) (\w+)(?: final)?(?: : [^;()]*)? ?\{)");
const std::regex inner_type_pattern(R"(^\s*(?:struct|class|enum class|enum|union) \w+[^;()]*\{)");
const std::regex constant_pattern(R"(^(?:inline )?constexpr [\w:<>, ]+ (\w+)(?:\[.*\])? ?[={])");
const std::regex number_pattern(
    R"(^\s*(?:inline |static )?constexpr (?:double|float|int|size_t|u?int\d+_t|std::array<.*>) \w+ ?[={])");
const std::regex function_pattern(R"(^[\w:<>,&*\[\] ]*?[ &*](\w+)\()");

/// The lines outside anonymous namespaces, comments left out.
std::vector<std::string> shared_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  bool hidden = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("namespace {", 0) == 0) hidden = true;
    const bool closes = line == "}  // namespace";
    if (closes) hidden = false;
    if (!hidden && !closes && line.rfind("//", 0) != 0) lines.push_back(line);
  }
  return lines;
}

bool begins_declaration(const std::string& line) {
  if (line.empty() || (std::isalpha(static_cast<unsigned char>(line[0])) == 0)) return false;
  for (const char* word : {"namespace", "using", "template", "static_assert", "friend", "extern"})
    if (line.rfind(word, 0) == 0) return false;
  return true;
}

/// The declaration that begins at line `i`, up to its body or its end; `i` becomes its last line.
std::string declaration(const std::vector<std::string>& lines, size_t& i) {
  std::string whole = lines[i];
  while (i + 1 < lines.size() && whole.find_first_of("{;") == std::string::npos)
    whole += " " + lines[++i];
  return whole;
}

}  // namespace

Names names_of(const std::string& text) {
  Names names;
  const std::vector<std::string> lines = shared_lines(text);
  for (size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (std::regex_search(lines[i], match, type_pattern)) names.types.push_back(match[1]);
    if (std::regex_search(lines[i], match, constant_pattern)) names.constants.push_back(match[1]);
    if (!begins_declaration(lines[i])) continue;
    const std::string whole = declaration(lines, i);
    const size_t body = whole.find('{');
    const size_t arguments = whole.find('(');
    const size_t value = whole.find('=');
    if (body == std::string::npos || arguments > body || value < arguments) continue;
    if (std::regex_search(whole, match, function_pattern)) names.functions.push_back(match[1]);
  }
  return names;
}

int type_count(const std::string& text) {
  int count = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    count += std::regex_search(line, inner_type_pattern) ? 1 : 0;
  return count;
}

int constant_count(const std::string& text) {
  int count = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    count += std::regex_search(line, number_pattern) ? 1 : 0;
  return count;
}

bool declares(const std::string& text, const std::string& name) {
  return std::regex_search(text, std::regex("\\b" + name + "\\("));
}

}  // namespace relievo::house
