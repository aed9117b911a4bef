#include "cli/cli_test.h"
#include "io/mesh/glb_decode.h"

namespace relievo {
namespace {

using InkOption = CliTest;

TEST_F(InkOption, ContoursBecomeLinesPaintOrNothing) {
  write("inked.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400">
  <g id="body" data-relievo="part"><circle cx="200" cy="200" r="120" fill="#ca8"
    stroke="#000" stroke-width="8"/></g></svg>)");
  const auto ink_of = [&](const std::string& name) {
    const std::string bytes = read(name);
    const auto glb = decode_glb(Bytes(bytes.begin(), bytes.end()));
    EXPECT_TRUE(glb.ok()) << name;
    return glb.ok() ? glb->model.ink.triangles.size() : 0;
  };
  const std::vector<std::string> base = {"build", "inked.svg", "-o", "m.glb", "--vertices", "3000"};
  const auto with = [&base](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return more;
  };
  ASSERT_EQ(relievo(with({"-o", "m.obj", "-o", "m.stl"})).exit_code, 0);
  const size_t lines = ink_of("m.glb");
  EXPECT_GT(lines, 100U);
  const std::string shell = read("m.glb");
  ASSERT_EQ(relievo(with({"--triangles", "1000"})).exit_code, 0);
  EXPECT_GT(ink_of("m.glb"), 100U);
  EXPECT_LT(ink_of("m.glb"), lines);
  for (const char* mode : {"paint", "none"}) {
    ASSERT_EQ(relievo(with({"--ink", mode})).exit_code, 0);
    EXPECT_EQ(ink_of("m.glb"), 0U);
  }
  ASSERT_EQ(relievo(with({"--ink", "shell"})).exit_code, 0);
  EXPECT_TRUE(read("m.glb") == shell);
  ASSERT_EQ(relievo(with({"--ink-width", "2"})).exit_code, 0);
  EXPECT_EQ(ink_of("m.glb"), lines);
  EXPECT_FALSE(read("m.glb") == shell);
  expect_failure(with({"--ink-width", "0"}), 2, "--ink-width");
  expect_failure({"build", "inked.svg", "-o", "n.obj", "--ink", "shell"}, 2,
                 ".glb, .usdz or .html");
}

TEST_F(InkOption, FiguresHaveLinesInGamesAndNoneInPrints) {
  write("inked.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="400">
  <g id="body" data-relievo="part"><circle cx="200" cy="200" r="120" fill="#ca8"
    stroke="#000" stroke-width="8"/></g></svg>)");
  const std::vector<std::string> base = {"build", "inked.svg", "--vertices",
                                         "3000",  "--profile", "figure"};
  const auto with = [&base](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return more;
  };
  ASSERT_EQ(relievo(with({"-o", "m.stl"})).exit_code, 0);
  const std::string alone = read("m.stl");
  ASSERT_EQ(relievo(with({"-o", "m.stl", "-o", "m.glb", "-o", "m.ply"})).exit_code, 0);
  EXPECT_TRUE(read("m.stl") == alone);
  const std::string bytes = read("m.glb");
  const auto glb = decode_glb(Bytes(bytes.begin(), bytes.end()));
  ASSERT_TRUE(glb.ok());
  EXPECT_GT(glb->model.ink.triangles.size(), 100U);
}

}  // namespace
}  // namespace relievo
