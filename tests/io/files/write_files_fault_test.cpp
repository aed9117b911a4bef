#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include "io/support/temporary_folder.h"
#include "relievo/files.h"

namespace {

/// The call of rename that fails, counted from 1; none when 0.
int failing_rename = 0;

}  // namespace

/// Takes the place of the C library's, so that the tests can make it fail.
extern "C" __attribute__((visibility("default"))) int rename(const char* from,
                                                             const char* to) noexcept {
  if (failing_rename > 0 && --failing_rename == 0) {
    errno = EIO;
    return -1;
  }
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace relievo {
namespace {

using Names = std::vector<std::string>;

TEST(WriteFilesFault, RenameThatFailsUndoesThoseBeforeIt) {
  for (int call = 1; call <= 4; ++call) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "a") << "old a";
    std::ofstream(folder.path() / "c") << "old c";
    failing_rename = call;
    const Status status = write_files({{folder.path() / "a", to_bytes("new a")},
                                       {folder.path() / "b", to_bytes("new b")},
                                       {folder.path() / "c", to_bytes("new c")}});
    EXPECT_EQ(status.ok(), call == 4);
    failing_rename = 0;
    if (call == 4) {
      EXPECT_EQ(content(folder.path() / "b"), "new b");
      continue;
    }
    EXPECT_EQ(status.error().code, ErrorCode::file);
    EXPECT_EQ(content(folder.path() / "a"), "old a");
    EXPECT_EQ(content(folder.path() / "c"), "old c");
    EXPECT_EQ(folder.names(), (Names{"a", "c"}));
  }
}

TEST(WriteFilesFault, FullDiskLeavesEverythingAsItWas) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << "old";
  rlimit unlimited{};
  getrlimit(RLIMIT_FSIZE, &unlimited);
  const rlimit small{1000, unlimited.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const Status status = write_files(
      {{folder.path() / "a", to_bytes("new")}, {folder.path() / "b", Bytes(100'000, 'x')}});
  setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::file);
  EXPECT_EQ(status.error().where, std::filesystem::canonical(folder.path()) / "b");
  EXPECT_EQ(content(folder.path() / "a"), "old");
  EXPECT_EQ(folder.names(), Names{"a"});
}

}  // namespace
}  // namespace relievo
