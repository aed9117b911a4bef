#include "samples/groundtruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "io/image/png.h"
#include "relievo/files.h"

namespace relievo::testing {
namespace {

namespace fs = std::filesystem;

Image16 values(const fs::path& path) {
  const auto bytes = read_file(path);
  EXPECT_TRUE(bytes.ok()) << path;
  if (!bytes) return {};
  const auto image = decode_png_values(*bytes);
  EXPECT_TRUE(image.ok()) << path;
  return image ? *image : Image16();
}

/// The rows of a table without its head.
std::vector<std::vector<std::string>> rows(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::vector<std::string>> table;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::vector<std::string> row;
    for (std::string field; std::getline(fields, field, '\t');) row.push_back(field);
    table.push_back(row);
  }
  return table;
}

TrueCharacter load(const fs::path& folder) {
  TrueCharacter character;
  character.name = folder.filename().string();
  character.labels = values(folder / "labels.png");
  const Image16 depth = values(folder / "depth_front_u16.png");
  character.depth = ImageF(depth.width, depth.height, 1);
  std::copy(depth.pixels.begin(), depth.pixels.end(), character.depth.pixels.begin());
  const std::set<uint16_t> seen(character.labels.pixels.begin(), character.labels.pixels.end());
  for (const auto& row : rows(folder / "parts.tsv")) {
    TruePart part{std::stoi(row[0]) + 1, row[3], {}};
    if (seen.count(static_cast<uint16_t>(part.label)) == 0) continue;
    const Image16 mask = values(folder / row[7]);
    part.mask = Image8(mask.width, mask.height, 1);
    for (size_t i = 0; i < mask.pixels.size(); ++i) part.mask.pixels[i] = mask.pixels[i] > 0;
    character.parts.push_back(std::move(part));
  }
  for (const auto& row : rows(folder / "pairs.tsv")) {
    const TruePair pair{std::stoi(row[0]) + 1, std::stoi(row[1]) + 1, std::stod(row[2]),
                        std::stod(row[3])};
    if (seen.count(static_cast<uint16_t>(pair.a)) + seen.count(static_cast<uint16_t>(pair.b)) == 2)
      character.pairs.push_back(pair);
  }
  return character;
}

}  // namespace

std::vector<TrueCharacter> true_characters() {
  const fs::path folder = RELIEVO_SHARED_DATA "/groundtruth";
  std::vector<fs::path> paths;
  if (!fs::is_directory(folder)) return {};
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<TrueCharacter> characters;
  for (const fs::path& path : paths) characters.push_back(load(path));
  return characters;
}

}  // namespace relievo::testing
