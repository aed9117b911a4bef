#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/geometry/polyline.h"
#include "understanding/areas/find_pieces.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

using Colour = std::array<uint8_t, 3>;

constexpr Colour brown = {150, 100, 60};
constexpr Colour white = {255, 255, 255};
constexpr Colour black = {20, 20, 20};

/// Painted limbs with inked outlines on white, each in front of those before.
class Painting {
 public:
  Painting() : rgba_(400, 400, 4, 255) {}

  Painting& limb(Point2 a, Point2 b, double radius, const Colour& colour = brown) {
    fill(a, b, radius + 4, black);
    fill(a, b, radius, colour);
    return *this;
  }

  /// Returns the drawing as it is, or with x and y exchanged.
  Drawing drawing(bool turned) const {
    if (!turned) return {rgba_};
    Drawing drawing{rgba_};
    for (int y = 0; y < rgba_.height; ++y)
      for (int x = 0; x < rgba_.width; ++x)
        for (int c = 0; c < 4; ++c) drawing.rgba.at(y, x, c) = rgba_.at(x, y, c);
    return drawing;
  }

 private:
  void fill(Point2 a, Point2 b, double radius, const Colour& colour) {
    for (int y = 0; y < rgba_.height; ++y)
      for (int x = 0; x < rgba_.width; ++x) {
        if (distance_to_polyline({a, b}, {x + 0.5, y + 0.5}) > radius) continue;
        for (int c = 0; c < 3; ++c) rgba_.at(x, y, c) = colour[static_cast<size_t>(c)];
      }
  }

  Image8 rgba_;
};

/// Expects a point of the painting to become background or not, as it is and turned.
void expect_background(const Painting& painting, Point2 place, bool expected) {
  for (const bool turned : {false, true}) {
    const auto s = segment_drawing(painting.drawing(turned));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    if (turned) std::swap(place.x, place.y);
    const int label = s->labels.at(static_cast<int>(place.x), static_cast<int>(place.y));
    EXPECT_EQ(label == 0, expected) << turned;
  }
}

/// A trunk with legs that cross at (200, 265).
Painting crossing_legs() {
  Painting painting;
  painting.limb({110, 130}, {290, 130}, 50);
  painting.limb({270, 150}, {130, 380}, 14).limb({130, 150}, {270, 380}, 14);
  return painting;
}

TEST(FindHoles, BetweenCrossingLegsIsBackground) {
  expect_background(crossing_legs(), {200, 215}, true);
}

TEST(FindHoles, InsideAnArmOnTheHipIsBackground) {
  Painting painting;
  painting.limb({180, 60}, {180, 360}, 45);
  painting.limb({200, 120}, {310, 200}, 14).limb({310, 200}, {200, 290}, 14);
  expect_background(painting, {255, 200}, true);
}

TEST(FindHoles, WhitePaintStays) {
  Painting painting;
  painting.limb({110, 130}, {290, 130}, 50).limb({150, 130}, {180, 130}, 20, white);
  painting.limb({270, 150}, {310, 380}, 14).limb({130, 150}, {90, 380}, 14);
  expect_background(painting, {165, 130}, false);
}

TEST(FindHoles, AreasWithDrawingInThemAreNoBackground) {
  expect_background(crossing_legs().limb({200, 215}, {200, 216}, 4, black), {200, 190}, false);
}

/// A body, 1, with an arm on its hip, 2, and the area that they enclose, 3.
Image16 arm_on_hip() {
  Image16 labels(300, 300, 1);
  const auto fill = [&labels](const Box2& box, uint16_t label) {
    for (int y = static_cast<int>(box.min.y); y < box.max.y; ++y)
      for (int x = static_cast<int>(box.min.x); x < box.max.x; ++x) labels.at(x, y) = label;
  };
  fill({{80, 20}, {140, 280}}, 1);
  fill({{140, 90}, {230, 210}}, 2);
  fill({{140, 110}, {210, 190}}, 3);
  return labels;
}

TEST(FindHoles, ABodysContourContinuesBehindItsArm) {
  const std::vector<HoleCue> cues = find_holes(arm_on_hip());
  ASSERT_FALSE(cues.empty());
  for (const HoleCue& cue : cues) {
    EXPECT_EQ(cue.area, 3);
    EXPECT_EQ(cue.before, 1);
    EXPECT_EQ(cue.after, 1);
  }
}

TEST(FindHoles, AreasOpenToTheBackgroundOrTheBorderAreNone) {
  Image16 open = arm_on_hip();
  for (int y = 140; y < 160; ++y)
    for (int x = 210; x < 230; ++x) open.at(x, y) = 0;
  EXPECT_TRUE(find_holes(open).empty());
  const Image16 whole = arm_on_hip();
  Image16 cut(200, 300, 1);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 200; ++x) cut.at(x, y) = whole.at(x, y);
  EXPECT_TRUE(find_holes(cut).empty());
}

}  // namespace
}  // namespace relievo::understanding
