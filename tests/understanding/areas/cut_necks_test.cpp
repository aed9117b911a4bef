#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "understanding/labels/drawing_evidence.h"
#include "understanding/labels/segment_drawing.h"

namespace relievo::understanding {
namespace {

constexpr int side = 420;
constexpr double pi = 3.14159265358979323846;

struct Capsule {
  Point2 a;
  Point2 b;
  double radius;
};

Point2 at_angle(double angle, double radius) {
  return Point2{side / 2.0, side / 2.0} + radius * Point2{std::cos(angle), std::sin(angle)};
}

/// One outline around all capsules, 4 px wide, on white.
Drawing outlined(const std::vector<Capsule>& capsules) {
  Drawing drawing{Image8(side, side, 4, 255)};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double outside = 1e9;
      for (const Capsule& c : capsules)
        outside = std::min(outside, distance_to_segment({x + 0.5, y + 0.5}, c.a, c.b) - c.radius);
      if (std::abs(outside) > 2) continue;
      for (int channel = 0; channel < 3; ++channel) drawing.rgba.at(x, y, channel) = 20;
    }
  return drawing;
}

/// A trunk with limbs at some distance from each other, and their tips.
struct Figure {
  std::vector<Capsule> capsules;
  std::vector<Point2> tips;
};

Figure figure_turned_by(double turn, int limbs) {
  Figure figure{{{at_angle(0, 0), at_angle(0, 0), 75}}, {}};
  for (int k = 0; k < limbs; ++k) {
    const double angle = turn + 2 * pi * k / limbs;
    const double radius = 13 + 3 * (k % 3);
    figure.tips.push_back(at_angle(angle, 160));
    figure.capsules.push_back({at_angle(angle, 40), figure.tips.back(), radius});
  }
  return figure;
}

uint16_t label_at(const Segmentation& s, Point2 p) {
  return s.labels.at(static_cast<int>(p.x), static_cast<int>(p.y));
}

TEST(CutNecks, LimbsOfOneOutlineArePartsWhateverTheirDirections) {
  for (int k = 0; k < 12; ++k) {
    const int limbs = 2 + k % 4;
    const Figure figure = figure_turned_by(0.37 * k, limbs);
    const Result<Segmentation> s = segment_drawing(outlined(figure.capsules));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(static_cast<int>(s->parts.size()), limbs + 1) << k;
    std::set<uint16_t> labels = {0, label_at(*s, at_angle(0, 0))};
    for (const Point2 tip : figure.tips) {
      labels.insert(label_at(*s, tip));
      const Point2 root = at_angle(0, 0) + 0.68 * (tip - at_angle(0, 0));
      EXPECT_EQ(label_at(*s, root), label_at(*s, tip)) << k << ": it is cut at its root";
    }
    EXPECT_EQ(static_cast<int>(labels.size()), limbs + 2) << k;
    EXPECT_EQ(static_cast<int>(s->bridges.size()), limbs) << "each cut is one, " << k;
  }
}

TEST(CutNecks, HeadsAreCutAtTheNeck) {
  for (int k = 0; k < 6; ++k) {
    const double turn = 0.9 * k;
    const Point2 head = at_angle(turn, 105);
    const std::vector<Capsule> capsules = {{at_angle(0, 0), at_angle(turn + pi, 60), 60},
                                           {head, at_angle(0, 0), 18},
                                           {head, head, 45}};
    const Result<Segmentation> s = segment_drawing(outlined(capsules));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 2U) << k;
    EXPECT_NE(label_at(*s, head), label_at(*s, at_angle(0, 0))) << k;
  }
}

TEST(CutNecks, FiguresWithoutNecksStayWhole) {
  const Point2 middle = at_angle(0, 0);
  const std::vector<std::vector<Capsule>> figures = {
      {{middle, middle, 100}},
      {{at_angle(0.4, 110), at_angle(0.4 + pi, 110), 40}},
      // A bent limb, a peanut with a wide waist and a body with a bump.
      {{at_angle(0, 130), middle, 30}, {middle, at_angle(2, 130), 30}},
      {{at_angle(1, 50), at_angle(1, 50), 70}, {at_angle(1 + pi, 50), at_angle(1 + pi, 50), 70}},
      {{middle, middle, 100}, {at_angle(2, 85), at_angle(2, 85), 30}}};
  for (size_t k = 0; k < figures.size(); ++k) {
    const Result<Segmentation> s = segment_drawing(outlined(figures[k]));
    ASSERT_TRUE(s.ok()) << to_string(s.error());
    EXPECT_EQ(s->parts.size(), 1U) << k;
  }
}

TEST(CutNecks, OneStrokeForALimbLeavesTheOthers) {
  const Figure figure = figure_turned_by(0.2, 4);
  Scribbles scribbles;
  scribbles.parts = {"arm"};
  const Point2 tip = figure.tips[1];
  Scribble stroke;
  stroke.kind = ScribbleKind::hard;
  stroke.part = 0;
  stroke.width = 8;
  stroke.points = {tip, tip + Point2{1, 1}};
  scribbles.strokes = {stroke};
  const Result<Segmentation> s = segment_drawing(outlined(figure.capsules), scribbles);
  ASSERT_TRUE(s.ok()) << to_string(s.error());
  EXPECT_EQ(s->parts.size(), 5U);
  EXPECT_EQ(s->parts[label_at(*s, tip) - 1].id, "arm");
  EXPECT_NE(label_at(*s, at_angle(0, 0)), label_at(*s, tip));
}

/// Two labels side by side on paint of one colour each, with or without a line between them.
std::vector<std::pair<uint16_t, uint16_t>> between(uint8_t left, uint8_t right, bool line) {
  Image8 rgba(60, 60, 4, 255);
  Image16 labels(60, 60, 1);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      labels.at(x, y) = x < 30 ? 1 : 2;
      for (int c = 0; c < 3; ++c)
        rgba.at(x, y, c) = line && std::abs(x - 30) < 2 ? 10 : x < 30 ? left : right;
    }
  return measure_evidence(rgba, labels).open;
}

TEST(OpenBorders, HaveNothingDrawnAlongThem) {
  const std::vector<std::pair<uint16_t, uint16_t>> pair = {{1, 2}};
  EXPECT_EQ(between(255, 255, false), pair);
  EXPECT_EQ(between(120, 128, false), pair);
  EXPECT_TRUE(between(255, 255, true).empty());
  EXPECT_TRUE(between(120, 120, true).empty());
  EXPECT_TRUE(between(120, 200, false).empty());
  EXPECT_TRUE(between(20, 20, false).empty()) << "ink would not be seen there";
}

}  // namespace
}  // namespace relievo::understanding
