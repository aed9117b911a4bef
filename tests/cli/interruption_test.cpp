#include <chrono>
#include <csignal>
#include <thread>

#include "cli/cli_test.h"

namespace relievo {
namespace {

using Interruption = CliTest;

TEST_F(Interruption, LeavesNothingHalfWritten) {
  write("m.glb", "before");
  const auto names = folder_.names();
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const int milliseconds : {400, 700, 1100}) {
      Process process(folder_.path(), {"build", "scene.json", "-o", "m.glb", "-o", "n.stl",
                                       "--vertices", "2000000"});
      process.wait_until_handled(signal);
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      process.send(signal);
      const Outcome outcome = process.wait();
      EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
      EXPECT_EQ(outcome.out, "");
      EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
      EXPECT_EQ(folder_.names(), names);
      EXPECT_EQ(read("m.glb"), "before");
    }
  }
}

/// Wherever the signal falls, the files are the old ones or the new ones, and the exit code says
/// which.
TEST_F(Interruption, IsAllOrNothingAtAnyTime) {
  const std::vector<std::string> arguments = {"build", "scene.json", "-o",         "m.glb",
                                              "-o",    "m.stl",      "--vertices", "2000"};
  ASSERT_EQ(relievo(arguments).exit_code, 0);
  const std::string glb = read("m.glb");
  const std::string stl = read("m.stl");
  const auto names = folder_.names();
  for (int milliseconds = 10; milliseconds < 200; milliseconds += 10) {
    write("m.glb", "old");
    write("m.stl", "old");
    Process process(folder_.path(), arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    process.send(SIGINT);
    const int code = process.wait().exit_code;
    ASSERT_TRUE(code == 0 || code == 130) << code;
    EXPECT_TRUE(read("m.glb") == (code == 0 ? glb : "old"));
    EXPECT_TRUE(read("m.stl") == (code == 0 ? stl : "old"));
    EXPECT_EQ(folder_.names(), names);
  }
}

}  // namespace
}  // namespace relievo
