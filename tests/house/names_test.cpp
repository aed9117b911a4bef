#include "house/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "house/source_files.h"

namespace relievo::house {
namespace {

constexpr int max_constants = 10;              ///< in a file
constexpr double max_types_per_thousand = 10;  ///< lines of the library

bool begins_with(const std::string& path, const std::string& start) {
  return path.rfind(start, 0) == 0;
}

/// Checks whether a file belongs to src/, whose paths begin with the room's name.
bool is_library(const std::string& path) {
  for (const char* top : {"relievo/", "apps/", "bindings/", "research/"})
    if (begins_with(path, top)) return false;
  return true;
}

bool is_source(const std::string& path) { return path.size() > 4 && path.ends_with(".cpp"); }

/// The files of libraries, programs and bindings.
std::vector<SourceFile> product_files() {
  std::vector<SourceFile> files;
  for (SourceFile& file : source_files())
    if (!begins_with(file.path, "tests/") && !begins_with(file.path, "benchmarks/") &&
        !begins_with(file.path, "fuzz/") && !begins_with(file.path, "research/tests/"))
      files.push_back(std::move(file));
  return files;
}

/// Two structs of one name break programs silently: the linker keeps one of their functions.
TEST(Names, HaveOneMeaning) {
  std::map<std::string, std::string> declared_in;
  for (const SourceFile& file : product_files()) {
    const Names names = names_of(file.text);
    for (const std::vector<std::string>& list : {names.types, names.constants})
      for (const std::string& name : list) {
        const auto [known, is_new] = declared_in.emplace(name, file.path);
        EXPECT_TRUE(is_new) << name << " is declared in " << known->second << " and in "
                            << file.path;
      }
  }
}

TEST(Names, AreDeclaredWhereTheirFileSays) {
  std::map<std::string, std::string> headers;
  for (const SourceFile& file : product_files())
    if (!is_source(file.path)) headers[file.path] = file.text;
  std::string interface;  // what users include: it is implemented in several folders
  for (const auto& [path, text] : headers)
    if (begins_with(path, "relievo/")) interface += text;
  for (const SourceFile& file : product_files()) {
    if (!is_source(file.path)) continue;
    const std::string header = file.path.substr(0, file.path.size() - 4) + ".h";
    for (const std::string& name : names_of(file.text).functions)
      EXPECT_TRUE(name == "main" || declares(headers[header], name) || declares(interface, name))
          << name << " of " << file.path << " is not declared in " << header;
  }
}

/// The interface has the limits of its values besides, which are not tuned.
TEST(Names, TunedConstantsAreFew) {
  for (const SourceFile& file : product_files()) {
    if (begins_with(file.path, "understanding/") || begins_with(file.path, "relievo/")) continue;
    EXPECT_LE(constant_count(file.text), max_constants) << file.path;
  }
}

/// Each type is a concept that a newcomer pays for.
TEST(Names, TypesAreFew) {
  double types = 0;
  double lines = 0;
  for (const SourceFile& file : product_files()) {
    if (!is_library(file.path)) continue;
    types += type_count(file.text);
    lines += static_cast<double>(std::count(file.text.begin(), file.text.end(), '\n'));
  }
  EXPECT_GT(lines, 0);
  EXPECT_LE(1000 * types / lines, max_types_per_thousand) << types << " types";
}

TEST(Names, AreFoundInText) {
  const Names names = names_of(
      "namespace relievo {\n"
      "namespace {\nstruct Hidden {\n};\nint hidden() {\n}\n}  // namespace\n"
      "struct Seen {\n};\nenum class Kind { a };\nclass Forward;\n"
      "constexpr double limit = 3;\nconst std::vector<int>& first(\n    int a) {\n}\n"
      "void later();\nint Seen::member() {\n}\n}  // namespace relievo\n");
  EXPECT_EQ(names.types, (std::vector<std::string>{"Seen", "Kind"}));
  EXPECT_EQ(names.constants, std::vector<std::string>{"limit"});
  EXPECT_EQ(names.functions, std::vector<std::string>{"first"});
  EXPECT_EQ(type_count("struct A {\n  enum class B { c };\n};\nclass D;\n"), 2);
  EXPECT_EQ(constant_count("constexpr int a = 1;\n  static constexpr double b = 2;\nint c = 3;\n"),
            2);
  EXPECT_TRUE(declares("int first(int a);", "first"));
  EXPECT_FALSE(declares("int firsts(int a);", "first"));
}

}  // namespace
}  // namespace relievo::house
