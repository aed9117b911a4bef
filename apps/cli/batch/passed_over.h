#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relievo::cli {

/// Describes files of a batch's folders that do not have the name of a drawing, one line a kind:
/// "art/fox.xcf: a picture of GIMP (XCF); export it as ...". Texts share the last line.
std::vector<std::string> describe_passed_over(const std::vector<std::filesystem::path>& files);

}  // namespace relievo::cli
