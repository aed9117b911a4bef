#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "io/scene/sample_scene.h"
#include "io/scene/scene_json.h"

namespace relievo {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// A number with arbitrary low bits, within the bounds of coordinates.
double rough_number(std::mt19937_64& random) {
  const double unit = static_cast<double>(random()) / 18446744073709551616.0;
  const int exponent = static_cast<int>(random() % 40) - 20;
  return std::ldexp(unit - 0.5, exponent);
}

TEST(WriteScene, IsAFixedPointOfReading) {
  const auto first = read_scene(sample_scene());
  ASSERT_TRUE(first);
  const auto text = write_scene(*first);
  ASSERT_TRUE(text);
  const auto second = read_scene(*text);
  ASSERT_TRUE(second) << to_string(second.error());
  EXPECT_EQ(*write_scene(*second), *text);
}

TEST(WriteScene, KeepsEveryBitOfEveryNumber) {
  std::mt19937_64 random(1);
  Scene scene;
  scene.width = 1e6;
  scene.height = std::nextafter(0.1, 1.0);
  for (int p = 0; p < 50; ++p) {
    Ring ring;
    for (int i = 0; i < 50; ++i) ring.push_back({rough_number(random), rough_number(random)});
    if (p == 0) ring.push_back({-0.0, std::numeric_limits<double>::denorm_min()});
    scene.parts.push_back(
        {"p" + std::to_string(p), {ring}, 4.0 / 3, -1.0 / 3, 1.0 / 7, {1.0 / 9, -0.7}});
    orient_by_nesting(scene.parts.back().outline);
  }
  const auto text = write_scene(scene);
  ASSERT_TRUE(text) << to_string(text.error());
  const auto back = read_scene(*text);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_TRUE(same_bits(back->height, scene.height));
  for (size_t p = 0; p < scene.parts.size(); ++p) {
    EXPECT_TRUE(same_bits(back->parts[p].c, scene.parts[p].c));
    EXPECT_TRUE(same_bits(back->parts[p].d, scene.parts[p].d));
    EXPECT_TRUE(same_bits(back->parts[p].flat, scene.parts[p].flat));
    EXPECT_TRUE(same_bits(back->parts[p].lean.x, scene.parts[p].lean.x));
    EXPECT_TRUE(same_bits(back->parts[p].lean.y, scene.parts[p].lean.y));
    const Ring& expected = scene.parts[p].outline[0];
    const Ring& read = back->parts[p].outline[0];
    ASSERT_EQ(read.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i) {
      EXPECT_TRUE(same_bits(read[i].x, expected[i].x));
      EXPECT_TRUE(same_bits(read[i].y, expected[i].y));
    }
  }
}

TEST(WriteScene, KeepsUnusualNames) {
  auto scene = read_scene(sample_scene());
  ASSERT_TRUE(scene);
  scene->parts[0].id = "čumák \"1\" \\ 🐺";
  const auto text = write_scene(*scene);
  ASSERT_TRUE(text);
  const auto back = read_scene(*text);
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(back->parts[0].id, scene->parts[0].id);
  EXPECT_EQ(back->joins[0].lower, 0);
}

TEST(WriteScene, RefusesWhatCannotBeRead) {
  const auto sample = read_scene(sample_scene());
  ASSERT_TRUE(sample);
  Scene scene = *sample;
  scene.parts[1].outline[0][2].x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_FALSE(write_scene(scene));
  EXPECT_EQ(write_scene(scene).error().where, "parts[1].outline[0][2]");
  scene = *sample;
  scene.parts[0].id = "\xff";
  ASSERT_FALSE(write_scene(scene));
  EXPECT_EQ(write_scene(scene).error().where, "parts[0].id");
  scene = *sample;
  scene.joins[0].lower = 7;
  ASSERT_FALSE(write_scene(scene));
  EXPECT_EQ(write_scene(scene).error().where, "joins[0].lower");
}

}  // namespace
}  // namespace relievo
