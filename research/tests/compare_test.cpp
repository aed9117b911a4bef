#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "io/image/decode_image.h"
#include "io/image/png.h"
#include "io/mesh/glb_decode.h"

namespace relievo::research {
namespace {

using Compare = CliTest;

nlohmann::json report_of(const std::string& text) {
  return nlohmann::json::parse(text, nullptr, false);
}

TEST_F(Compare, WritesTheModelsMapsAndMeasuresOfEveryMethod) {
  for (const std::string method :
       {"relievo", "pillows", "firm-ends", "parabolic", "ink-and-ray", "entem"}) {
    const Outcome outcome =
        relievo({"scene.json", "--as", method, "--vertices", "3000", "-o", method + ".glb",
                 "--normal-map", method + "-n.png", "--depth-map", method + "-d.png", "--map-size",
                 "200", "--report", method + ".json"});
    ASSERT_EQ(outcome.exit_code, 0) << method << ": " << outcome.err;
    EXPECT_NE(outcome.out.find(method + ".glb"), std::string::npos);
    const auto model = decode_glb(to_bytes(read(method + ".glb")));
    ASSERT_TRUE(model) << method;
    const auto map = decode_image(to_bytes(read(method + "-n.png")));
    ASSERT_TRUE(map) << method;
    EXPECT_EQ(map->width, 200);
    EXPECT_TRUE(decode_image(to_bytes(read(method + "-d.png"))));
    const nlohmann::json report = report_of(read(method + ".json"));
    ASSERT_FALSE(report.is_discarded());
    EXPECT_EQ(report["method"], method);
    EXPECT_EQ(report["faces"], model->model.triangles.size());
    EXPECT_GT(report["slope_jump_degrees"]["count"], 0) << method;
    EXPECT_GT(report["contour_iou"], 0.8) << method;
  }
  EXPECT_GT(report_of(read("pillows.json"))["slope_jump_degrees"]["median"], 30);
  EXPECT_LT(report_of(read("relievo.json"))["slope_jump_degrees"]["median"], 3);
  EXPECT_LT(report_of(read("entem.json"))["contour_iou"],
            report_of(read("relievo.json"))["contour_iou"]);
}

TEST_F(Compare, GraftsWhereAMaskSays) {
  Image8 mask(40, 40, 3);
  const auto depth_with = [&](const std::string& name) {
    const auto bytes = encode_png(mask);
    write("mask.png", std::string(bytes->begin(), bytes->end()));
    const Outcome outcome =
        relievo({"scene.json", "--as", "ink-and-ray", "--vertices", "3000", "--graft-mask",
                 "mask.png", "--depth-map", name, "--map-size", "100"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return read(name);
  };
  const std::string nowhere = depth_with("nowhere.png");
  mask.pixels.assign(mask.pixels.size(), 255);
  EXPECT_NE(depth_with("everywhere.png"), nowhere);
}

TEST_F(Compare, RefusesWhatItCannotDo) {
  expect_failure({"scene.json", "--as", "pillows"}, 2, "nothing to write");
  expect_failure({"scene.json", "--as", "magic", "-o", "a.glb"}, 2, "magic");
  expect_failure({"scene.json", "-o", "a.glb"}, 2, "--as");
  expect_failure({"scene.json", "--as", "entem", "-o", "a.3mf"}, 2, ".glb");
  expect_failure({"missing.json", "--as", "entem", "-o", "a.glb"}, 6, "missing.json");
  expect_failure(
      {"scene.json", "--as", "ink-and-ray", "-o", "a.glb", "--graft-mask", "missing.png"}, 6,
      "missing.png");
  expect_failure({"scene.json", "--as", "entem", "-o", "none/a.glb"}, 6, "folder");
}

}  // namespace
}  // namespace relievo::research
