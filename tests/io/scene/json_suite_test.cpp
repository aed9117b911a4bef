#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "io/scene/json_reader.h"
#include "io/scene/scene_json.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// The files of the JSON test suite whose name begins with `kind`: y (JSON), n (not JSON) or
/// i (up to the reader); sorted.
std::vector<fs::path> suite(char kind) {
  const fs::path folder = fs::path(RELIEVO_SHARED_DATA) / "adversarial/json/JSONTestSuite";
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".json" && entry.path().filename().string()[0] == kind)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_malformed(const Error& error) {
  return error.message.find("malformed JSON") == 0 ||
         error.message.find("nested deeper") != std::string::npos;
}

#define SKIP_WITHOUT(files) \
  if ((files).empty()) GTEST_SKIP() << "the JSON test suite is not beside the repository"

TEST(JsonSuite, ValidFilesAreJsonButNoScenes) {
  const auto files = suite('y');
  SKIP_WITHOUT(files);
  for (const fs::path& file : files) {
    const auto scene = read_scene(content(file));
    ASSERT_FALSE(scene) << file;
    EXPECT_FALSE(is_malformed(scene.error())) << file << " " << to_string(scene.error());
    EXPECT_EQ(scene.error().code, ErrorCode::bad_input) << file;
    const bool repeats_a_key = file.filename().string().find("duplicated") != std::string::npos;
    EXPECT_EQ(parse_json(content(file)).ok(), !repeats_a_key) << file;
  }
}

TEST(JsonSuite, InvalidFilesAreRefusedAsMalformed) {
  const auto files = suite('n');
  SKIP_WITHOUT(files);
  for (const fs::path& file : files) {
    const auto scene = read_scene(content(file));
    ASSERT_FALSE(scene) << file;
    EXPECT_TRUE(is_malformed(scene.error())) << file << " " << to_string(scene.error());
  }
}

TEST(JsonSuite, DoubtfulFilesAreNoScenes) {
  const auto files = suite('i');
  SKIP_WITHOUT(files);
  for (const fs::path& file : files) EXPECT_FALSE(read_scene(content(file))) << file;
}

}  // namespace
}  // namespace relievo
