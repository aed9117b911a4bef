#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/maps/encode_maps.h"
#include "io/support/raw_png.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

using namespace testing;

TEST(CarveMap, HasTheHeightsOfABall) {
  const double radius = 20;
  const Model ball = hemisphere(radius, 64);
  const auto png = encode_carve_map(ball, 4, 3);
  ASSERT_TRUE(png.ok());
  const RawPng map = read_raw_png(*png);
  EXPECT_EQ(map.bit_depth, 16);
  ASSERT_EQ(map.samples.width, 160);
  ASSERT_EQ(map.samples.height, 160);
  EXPECT_EQ(map.texts.at("px_per_mm"), "4");
  EXPECT_EQ(map.texts.at("base_mm"), "3");
  EXPECT_NEAR(std::stod(map.texts.at("depth_mm")), radius, 1e-9);
  int checked = 0;
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const double r = std::hypot(x + 0.5 - 80, y + 0.5 - 80) / 4;
      if (r > radius) {
        EXPECT_EQ(map.samples.at(x, y), 0);
      }
      if (r > 0.9 * radius) continue;
      const double height = map.samples.at(x, y) / 65535.0 * radius;
      EXPECT_NEAR(height, std::sqrt(radius * radius - r * r), 0.02) << x << " " << y;
      ++checked;
    }
  EXPECT_GT(checked, 10000);
}

TEST(CarveMap, HasTheTopOfTheDrawingAtTheTop) {
  Model model = empty_model(100, 100);
  add_ellipsoid(model, {"high", {20, 20}, 0, {10, 10, 20}});
  add_ellipsoid(model, {"low", {80, 80}, 0, {10, 10, 5}});
  const RawPng map = read_raw_png(*encode_carve_map(model, 1, 2));
  EXPECT_GT(map.samples.at(10, 10), 65000);
  EXPECT_NEAR(map.samples.at(70, 70), 65535 / 4, 200);
  EXPECT_EQ(map.samples.at(70, 10), 0);
}

TEST(CarveMap, RefusesTooManyPixels) {
  const auto png = encode_carve_map(hemisphere(20, 8), 1000, 2);
  ASSERT_FALSE(png.ok());
  EXPECT_EQ(png.error().code, ErrorCode::limit);
}

}  // namespace
}  // namespace relievo
