#include "solid/paint_behind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "solid/solid_case.h"
#include "support/sample_models.h"
#include "support/scenes.h"

namespace relievo {
namespace {

using namespace testing;

constexpr int side = 200;  ///< px of drawings; the ball has a radius of 80 px on them

/// A ball of radius 40 px in front of its one part.
relief::VisibleSheet backed_ball() {
  relief::VisibleSheet sheet{hemisphere(40, 64), {}, {}};
  for (const Point3 p : sheet.model.positions) sheet.back.push_back({-p.z, 0});
  return sheet;
}

double from_middle(int x, int y) { return std::hypot(x + 0.5 - 0.5 * side, y + 0.5 - 0.5 * side); }

/// Draws with colour(x, y), grey.
template <class Colour>
Drawing drawn(Colour colour) {
  Drawing drawing{Image8(side, side, 4, 255)};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c) drawing.rgba.at(x, y, c) = static_cast<uint8_t>(colour(x, y));
  return drawing;
}

/// Calls visit(x, y) for the pixels of the ball.
template <class Visit>
void for_each_on_ball(Visit visit) {
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (from_middle(x, y) < 79) visit(x, y);
}

TEST(PaintBehind, OfOneColourIsThatColour) {
  const Image8 behind = paint_behind(backed_ball(), drawn([](int, int) { return 90; }));
  for_each_on_ball([&](int x, int y) { EXPECT_NEAR(behind.at(x, y), 90, 1); });
}

TEST(PaintBehind, IsHarmonicFromTheSilhouette) {
  // x is harmonic. What the front shows off the silhouette does not matter.
  const auto ramp = [](int x, int y) { return from_middle(x, y) < 60 ? 230 : 28 + x; };
  const Image8 behind = paint_behind(backed_ball(), drawn(ramp));
  for_each_on_ball([&](int x, int y) {
    if (from_middle(x, y) < 50) {
      EXPECT_NEAR(behind.at(x, y), 28 + x, 6);
    }
  });
}

TEST(PaintBehind, LeavesOutMarksAndKeepsGrain) {
  const auto grained = [](int x, int y) { return 150 + ((x / 2 + y / 2) % 2 == 0 ? 8 : -8); };
  const auto marked = [&](int x, int y) {
    return std::hypot(x - 110, y - 80) < 12 ? 0 : grained(x, y);
  };
  const Image8 behind = paint_behind(backed_ball(), drawn(marked));
  double variance = 0;
  int count = 0;
  for_each_on_ball([&](int x, int y) {
    EXPECT_NEAR(behind.at(x, y), 150, 25);
    if (from_middle(x, y) > 60) return;
    variance += std::pow(behind.at(x, y) - 150.0, 2);
    ++count;
  });
  EXPECT_NEAR(std::sqrt(variance / count), 8, 3);
}

TEST(PaintBehind, MeetsTheFrontAtTheSilhouette) {
  const auto striped = [](int x, int) { return x / 20 % 2 == 0 ? 60 : 200; };
  const Image8 behind = paint_behind(backed_ball(), drawn(striped));
  for_each_on_ball([&](int x, int y) {
    if (from_middle(x, y) > 78.4) {
      EXPECT_NEAR(behind.at(x, y), striped(x, y), 12) << x << " " << y;
    }
  });
}

TEST(Back, IsOfPartsThatReachTheSilhouette) {
  Scene scene;
  scene.width = scene.height = 200;
  scene.parts = {part("body", circle({100, 100}, 80)), part("eye", circle({100, 100}, 20))};
  const relief::VisibleSheet sheet = sheet_of(scene, 2000, true);
  ASSERT_EQ(sheet.model.parts.size(), 2U);
  EXPECT_GT(sheet.model.parts[1].triangle_count, 10);
  for (const relief::BackPoint& back : sheet.back) EXPECT_EQ(back.part, 0);
}

}  // namespace
}  // namespace relievo
