#include "house/source_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace relievo::house {

namespace fs = std::filesystem;

std::vector<SourceFile> source_files() {
  const fs::path root = RELIEVO_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* top :
       {"include", "src", "apps", "bindings", "research", "tests", "benchmarks", "fuzz"}) {
    if (!fs::exists(root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const fs::path extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream in(entry.path(), std::ios::binary);
      const bool is_library = std::string(top) == "src" || std::string(top) == "include";
      const fs::path base = is_library ? root / top : root;
      files.push_back({entry.path().lexically_relative(base).generic_string(),
                       {std::istreambuf_iterator<char>(in), {}}});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

}  // namespace relievo::house
