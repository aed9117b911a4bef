#include <gtest/gtest.h>

#include "io/support/temporary_folder.h"
#include "relievo/files.h"

namespace relievo {
namespace {

TEST(ReadFile, ReturnsEveryByte) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 200'000; ++i) text.push_back(static_cast<char>(i * 7 % 256));
  std::ofstream(folder.path() / "a", std::ios::binary) << text;
  const Result<Bytes> bytes = read_file(folder.path() / "a");
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(to_text(*bytes), text);
}

TEST(ReadFile, StopsAtTheLimit) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << std::string(100, 'x');
  EXPECT_TRUE(read_file(folder.path() / "a", 100).ok());
  const Result<Bytes> refused = read_file(folder.path() / "a", 99);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::limit);
  EXPECT_EQ(refused.error().where, (folder.path() / "a").string());
}

TEST(ReadFile, StopsAtTheLimitOfAnEndlessDevice) {
  const Result<Bytes> refused = read_file("/dev/zero", 1 << 20);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::limit);
}

TEST(ReadFile, NamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  for (const std::filesystem::path& path : {folder.path() / "absent", folder.path()}) {
    const Result<Bytes> refused = read_file(path);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::file);
    EXPECT_EQ(refused.error().where, path.string());
  }
}

}  // namespace
}  // namespace relievo
