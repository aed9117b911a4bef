#include <gtest/gtest.h>

#include "io/support/temporary_folder.h"
#include "relievo/files.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(WriteFiles, WritesAllAndLeavesNothingElse) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "b") << "old";
  const Status status = write_files({{folder.path() / "a", to_bytes("first")},
                                     {folder.path() / "b", to_bytes("second")},
                                     {folder.path() / "empty", {}}});
  ASSERT_TRUE(status.ok()) << to_string(status.error());
  EXPECT_EQ(content(folder.path() / "a"), "first");
  EXPECT_EQ(content(folder.path() / "b"), "second");
  EXPECT_EQ(folder.names(), (Names{"a", "b", "empty"}));
}

TEST(WriteFiles, FailureBeforeTheEndLeavesEverythingAsItWas) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << "old";
  const Status status = write_files({{folder.path() / "a", to_bytes("new")},
                                     {folder.path() / "fresh", to_bytes("new")},
                                     {folder.path() / "absent" / "b", to_bytes("new")}});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::file);
  EXPECT_NE(status.error().where.find("absent"), std::string::npos);
  EXPECT_EQ(content(folder.path() / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(WriteFiles, ANameThatIsTooLongIsRolledBack) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << "old";
  const Status status = write_files({{folder.path() / "a", to_bytes("new")},
                                     {folder.path() / "fresh", to_bytes("new")},
                                     {folder.path() / std::string(300, 'n'), to_bytes("new")}});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::file);
  EXPECT_EQ(content(folder.path() / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(WriteFiles, NeverOverwritesAnInput) {
  const TemporaryFolder folder;
  const fs::path input = folder.path() / "input";
  std::ofstream(input) << "precious";
  fs::create_hard_link(input, folder.path() / "hard");
  fs::create_symlink(input, folder.path() / "soft");
  fs::create_directory(folder.path() / "sub");
  for (const fs::path& alias :
       {input, folder.path() / "hard", folder.path() / "soft", folder.path() / "sub/../input"}) {
    const Status status = write_files({{alias, to_bytes("lost")}}, {input});
    ASSERT_FALSE(status.ok()) << alias;
    EXPECT_EQ(status.error().code, ErrorCode::usage);
    EXPECT_EQ(content(input), "precious");
  }
  EXPECT_EQ(folder.names(), (Names{"hard", "input", "soft", "sub"}));
}

TEST(WriteFiles, KeepsLinksAndPermissionsOfWhatItReplaces) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "target";
  std::ofstream(target) << "old";
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, folder.path() / "link");
  ASSERT_TRUE(write_files({{folder.path() / "link", to_bytes("new")}}).ok());
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(content(target), "new");
  EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(WriteFiles, RefusesFoldersDevicesAndDoubles) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_files({{folder.path(), {}}}).error().code, ErrorCode::file);
  EXPECT_EQ(write_files({{"/dev/null", {}}}).error().code, ErrorCode::file);
  EXPECT_EQ(write_files({{"", {}}}).error().code, ErrorCode::file);
  const Status twice = write_files({{folder.path() / "a", {}}, {folder.path() / "./a", {}}});
  EXPECT_EQ(twice.error().code, ErrorCode::usage);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace relievo
