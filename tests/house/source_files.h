#pragma once

#include <string>
#include <vector>

namespace relievo::house {

struct SourceFile {
  std::string path;  ///< as in an include
  std::string text;
};

/// Reads all C++ files of the repository, sorted by path.
std::vector<SourceFile> source_files();

}  // namespace relievo::house
