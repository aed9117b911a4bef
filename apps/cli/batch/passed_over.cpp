#include "apps/cli/batch/passed_over.h"

#include <fstream>
#include <map>
#include <utility>

#include "io/files/file_kind.h"

namespace relievo::cli {
namespace {

namespace fs = std::filesystem;

/// Number of bytes that are read to find out what a file is.
constexpr size_t looked_at = size_t{1} << 20;

/// Number of files of a kind that are named.
constexpr size_t most_names = 5;

FileKind kind_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  Bytes head(looked_at);
  file.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(looked_at));
  head.resize(static_cast<size_t>(file.gcount()));
  return file_kind(head);
}

/// Says what a file is and what to do; empty for files that are no drawings.
std::string advice_on(const FileKind& kind) {
  switch (kind.kind) {
    case InputKind::json:
    case InputKind::text:
    case InputKind::unknown:
      return "";
    case InputKind::foreign:
    case InputKind::sprites:
    case InputKind::glb:
      return std::string(kind.name) + "; " + std::string(kind.remedy);
    case InputKind::zip:
      return std::string(kind.name) + (kind.remedy.empty()
                                           ? "; name it on its own if it is a drawing or a project"
                                           : "; " + std::string(kind.remedy));
    default:
      return std::string(kind.name) + "; give it the usual ending, or name it on its own";
  }
}

std::string names_of(const std::vector<fs::path>& files) {
  std::string names;
  for (size_t i = 0; i < files.size() && i < most_names; ++i)
    names += (i > 0 ? ", " : "") + files[i].generic_string();
  if (files.size() > most_names)
    names += " and " + std::to_string(files.size() - most_names) + " more";
  return names;
}

}  // namespace

std::vector<std::string> describe_passed_over(const std::vector<fs::path>& files) {
  std::map<std::string, std::vector<fs::path>> by_advice;
  for (const fs::path& file : files) by_advice[advice_on(kind_of(file))].push_back(file);
  std::vector<std::string> lines;
  for (const auto& [advice, some] : by_advice)
    if (!advice.empty()) lines.push_back(names_of(some) + ": " + advice);
  if (const auto rest = by_advice.find(""); rest != by_advice.end())
    lines.push_back(names_of(rest->second) + ": no drawings");
  return lines;
}

}  // namespace relievo::cli
