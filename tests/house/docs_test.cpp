#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace relievo::house {
namespace {

namespace fs = std::filesystem;

const fs::path repository = RELIEVO_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// All pages of the documentation.
std::vector<fs::path> pages() {
  std::vector<fs::path> found;
  for (const char* page : {"README.md", "CHANGELOG.md", "SECURITY.md", "examples/README.md"})
    found.push_back(repository / page);
  for (const auto& entry : fs::recursive_directory_iterator(repository / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

/// The lines of a page outside of blocks of code.
std::vector<std::string> prose(const fs::path& page) {
  std::vector<std::string> lines;
  std::istringstream text(text_of(page));
  bool code = false;
  for (std::string line; std::getline(text, line);) {
    if (line.rfind("```", 0) == 0) code = !code;
    if (!code) lines.push_back(line);
  }
  return lines;
}

/// The name by which a link leads to a heading: lower case, hyphens for spaces, no punctuation.
std::string anchor(const std::string& heading) {
  std::string name;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      name += '-';
    else if (byte >= 128 || std::isalnum(byte) != 0 || c == '-' || c == '_')
      name += static_cast<char>(std::tolower(byte));
  }
  return name;
}

std::set<std::string> anchors(const fs::path& page) {
  std::set<std::string> names;
  for (const std::string& line : prose(page))
    if (const size_t text = line.find_first_not_of('#'); text > 0 && text != std::string::npos)
      names.insert(anchor(line.substr(text + 1)));
  return names;
}

std::vector<std::smatch> matches(const std::string& line, const std::regex& pattern) {
  return {std::sregex_iterator(line.begin(), line.end(), pattern), std::sregex_iterator()};
}

TEST(Docs, LinksLeadSomewhere) {
  const std::regex link(R"(\]\(([^)#\s]*)(#[^)\s]+)?\))");
  size_t count = 0;
  for (const fs::path& page : pages())
    for (const std::string& line : prose(page))
      for (const std::smatch& match : matches(line, link)) {
        const std::string target = match[1];
        if (target.find("://") != std::string::npos) continue;
        const fs::path file = target.empty() ? page : page.parent_path() / target;
        EXPECT_TRUE(fs::exists(file)) << page << " links to " << target;
        if (match[2].matched) {
          EXPECT_EQ(anchors(file).count(match[2].str().substr(1)), 1U) << page << ": " << line;
        }
        ++count;
      }
  EXPECT_GT(count, 100U);
}

TEST(Docs, ArchitectureNamesSourcesThatExist) {
  const std::regex source(R"(`(\w+/[\w/]+\.cpp)`)");
  size_t count = 0;
  for (const std::string& line : prose(repository / "docs/architecture.md"))
    for (const std::smatch& match : matches(line, source)) {
      EXPECT_TRUE(fs::exists(repository / "src" / match[1].str())) << match[1];
      ++count;
    }
  EXPECT_GT(count, 10U);
}

TEST(Docs, SourcesNamePagesThatExist) {
  const std::regex name(R"(docs/[\w/-]+\.(md|json))");
  size_t count = 0;
  for (const char* top : {"include", "src", "apps", "bindings", "scripts", "web/document"})
    for (const auto& entry : fs::recursive_directory_iterator(repository / top)) {
      if (!entry.is_regular_file()) continue;
      std::istringstream text(text_of(entry.path()));
      for (std::string line; std::getline(text, line);)
        for (const std::smatch& match : matches(line, name)) {
          EXPECT_TRUE(fs::exists(repository / match[0].str())) << entry.path() << ": " << line;
          ++count;
        }
    }
  EXPECT_GT(count, 5U);
}

}  // namespace
}  // namespace relievo::house
