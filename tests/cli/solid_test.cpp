#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/mesh/glb_decode.h"
#include "io/mesh/placement.h"

namespace relievo {
namespace {

using SolidBuild = CliTest;
using Json = nlohmann::json;

std::vector<std::string> coarse(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--vertices", "3000"});
  return arguments;
}

TEST_F(SolidBuild, ReportsASolid) {
  const auto solid = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments = coarse(
        {"build", "scene.json", "-o", "m.stl", "--json", "--profile", "solid", "--size", "40"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out)["solid"];
  };
  const Json plain = solid({});
  EXPECT_EQ(plain["pieces"], 1);
  EXPECT_GT(plain["volume_mm3"], 0);
  for (const std::vector<std::string>& change :
       std::vector<std::vector<std::string>>{{"--thickness", "4"},
                                             {"--base", "outline"},
                                             {"--base", "plate"},
                                             {"--base", "plate", "--margin", "5"},
                                             {"--base", "plate", "--corner", "0"},
                                             {"--base", "round"},
                                             {"--base", "plate", "--margin", "5", "--hole", "3"},
                                             {"--base", "outline", "--ring", "3"},
                                             {"--base", "outline", "--cutter", "12"}})
    EXPECT_NE(solid(change)["volume_mm3"], plain["volume_mm3"]) << change.back();
}

TEST_F(SolidBuild, PrintsAFigureOnABaseUpright) {
  const auto corner = [&](const std::vector<std::string>& base) {
    std::vector<std::string> arguments =
        coarse({"build", "scene.json", "-o", "m.stl", "-o", "m.glb", "--profile", "figure"});
    arguments.insert(arguments.end(), base.begin(), base.end());
    const Outcome outcome = relievo(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    // Binary: 80 bytes, a count, then 50 bytes a triangle of which the first 12 are its normal.
    const std::string stl = read("m.stl");
    std::array<float, 3> most{};
    for (size_t at = 84; at + 50 <= stl.size(); at += 50)
      for (size_t v = 0; v < 9; ++v) {
        float value = 0;
        std::memcpy(&value, stl.data() + at + 12 + 4 * v, 4);
        most[v % 3] = std::max(most[v % 3], value);
      }
    const std::string bytes = read("m.glb");
    const auto glb = decode_glb(Bytes(bytes.begin(), bytes.end()));
    EXPECT_TRUE(glb.ok());
    const Box3 box = extent(glb->model);
    const Point3 sides = (1 / longest_side(glb->model)) * (box.max - box.min);
    const float longest = std::max({most[0], most[1], most[2]});
    EXPECT_NEAR(most[0] / longest, sides.x, 1e-3);
    EXPECT_NEAR(most[1] / longest, base.empty() ? sides.y : sides.z, 1e-3);
    EXPECT_NEAR(most[2] / longest, base.empty() ? sides.z : sides.y, 1e-3);
    return std::abs(sides.y - sides.z);
  };
  EXPECT_GT(corner({}), 0.01);
  EXPECT_GT(corner({"--base", "round"}), 0.01);
}

TEST_F(SolidBuild, CarvesAMapOfASolid) {
  const std::vector<std::string> carve = {"build", "scene.json", "--carve-map", "c.png"};
  expect_failure(carve, 2, "--profile solid");
  std::vector<std::string> options = coarse(carve);
  options.insert(options.end(), {"--profile", "solid", "--size", "50", "--px-per-mm", "4"});
  EXPECT_EQ(relievo(options).exit_code, 0);
  const std::string text = read("c.png");
  const auto map = decode_image(Bytes(text.begin(), text.end()));
  ASSERT_TRUE(map.ok());
  EXPECT_EQ(std::max(map->width, map->height), 200);
}

}  // namespace
}  // namespace relievo
