#include "relief/finish/ink_rims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "support/analytic_discs.h"
#include "support/model_checks.h"
#include "support/scenes.h"

namespace relievo::relief {
namespace {

using namespace testing;

constexpr int canvas_width = 320;
constexpr int canvas_height = 240;
constexpr double ink_width = 5;
const Disc inked_ball{{110, 120}, 80};
const Disc nearer{{190, 120}, 60, 1, 60};

/// Discs with light paint, and ink of this width inside their outlines.
Drawing drawn(const std::vector<Disc>& discs, double broad) {
  Drawing drawing{Image8(canvas_width, canvas_height, 4)};
  for (int y = 0; y < canvas_height; ++y)
    for (int x = 0; x < canvas_width; ++x)
      for (const Disc& disc : discs) {
        const double r = distance({x + 0.5, y + 0.5}, disc.centre);
        if (r > disc.radius) continue;
        const uint8_t value = r > disc.radius - broad ? 20 : 200;
        std::fill_n(&drawing.rgba.at(x, y), 3, value);
        drawing.rgba.at(x, y, 3) = 255;
      }
  return drawing;
}

Model model_of(const std::vector<Disc>& discs) {
  return assemble(make_discs(discs, canvas_width, canvas_height, 4), Visibility::orbit);
}

bool is_dark(const Drawing& drawing, Point2 uv) {
  const int x = std::clamp(static_cast<int>(uv.x * canvas_width), 0, canvas_width - 1);
  const int y = std::clamp(static_cast<int>(uv.y * canvas_height), 0, canvas_height - 1);
  return drawing.rgba.at(x, y, 3) == 0 || drawing.rgba.at(x, y) < 100;
}

/// The range of heights over which ink is seen from the side, px.
double depth_of_ink(const Model& model, const Drawing& drawing) {
  double least = 1e9;
  double most = -1e9;
  for (const auto& triangle : model.triangles)
    for (const int v : triangle) {
      if (!is_dark(drawing, model.uvs[v])) continue;
      least = std::min(least, model.positions[v].z);
      most = std::max(most, model.positions[v].z);
    }
  return most - least;
}

Point2 place(const Point3& p) { return {p.x, canvas_height - p.y}; }

/// The vertices of a part's triangles, as often as they have it.
std::vector<int> corners_of(const Model& model, size_t part) {
  std::vector<int> corners;
  const ModelPart& p = model.parts[part];
  for (int t = p.first_triangle; t < p.first_triangle + p.triangle_count; ++t)
    corners.insert(corners.end(), model.triangles[t].begin(), model.triangles[t].end());
  return corners;
}

TEST(InkRims, InkIsAThinLineFromTheSide) {
  const Drawing drawing = drawn({inked_ball}, ink_width);
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawing);
  // On a ball of radius R ink of width w reaches sqrt(2 R w - w^2) deep.
  const double deep = std::sqrt(2 * inked_ball.radius * ink_width - ink_width * ink_width);
  EXPECT_NEAR(depth_of_ink(before, drawing), deep, 0.2 * deep);
  EXPECT_LT(depth_of_ink(after, drawing), ink_width);
}

TEST(InkRims, PaintRoundsOffToTheInk) {
  const Drawing drawing = drawn({inked_ball}, ink_width);
  Model model = model_of({inked_ball});
  narrow_inked_rims(model, drawing);
  double lowest = inked_ball.radius;
  for (const int v : corners_of(model, 0)) {
    const Point3 p = model.positions[v];
    if (!is_dark(drawing, model.uvs[v])) lowest = std::min(lowest, p.z);
    // The ball that is left within the ink lies below.
    const double inner = inked_ball.radius - 1.6 * ink_width;
    const double r = distance(place(p), inked_ball.centre);
    EXPECT_GE(p.z, std::sqrt(std::max(0.0, inner * inner - r * r)) - 1) << r;
  }
  EXPECT_LT(lowest, ink_width);
}

TEST(InkRims, FrontStaysAsDrawn) {
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawn({inked_ball}, ink_width));
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_TRUE(after.normals == before.normals);
  EXPECT_TRUE(after.uvs == before.uvs);
  ASSERT_EQ(after.positions.size(), before.positions.size());
  for (size_t v = 0; v < before.positions.size(); ++v) {
    EXPECT_EQ(after.positions[v].x, before.positions[v].x);
    EXPECT_EQ(after.positions[v].y, before.positions[v].y);
    EXPECT_LE(after.positions[v].z, before.positions[v].z);
    const double r = distance(place(before.positions[v]), inked_ball.centre);
    if (r < inked_ball.radius - 8 * ink_width) {
      EXPECT_EQ(after.positions[v].z, before.positions[v].z);
    }
  }
}

/// Two balls drawn as one outline with a line between them, joined there.
TEST(InkRims, JoinsStay) {
  const Disc body{{110, 120}, 80};
  const Disc head{{215, 120}, 60};
  Scene scene;
  scene.width = canvas_width;
  scene.height = canvas_height;
  scene.parts = {part("body", circle(body.centre, body.radius)),
                 part("head", circle(head.centre, head.radius))};
  std::vector<Point2> line;
  for (double a = -0.7; a < 0.75; a += 0.1)
    line.push_back(head.centre - head.radius * Point2{std::cos(a), std::sin(a)});
  scene.joins = {{1, 0, line}};
  ReliefOptions options;
  options.hidden = true;
  options.layers.vertex_budget = 6000;
  const auto relief = build_relief(scene, options);
  ASSERT_TRUE(relief.ok());
  const auto before =
      assemble_model({relief->layers, relief->inflation, relief->ordering, scene}, {});
  ASSERT_TRUE(before.ok());
  Model after = *before;
  narrow_inked_rims(after, drawn({body, head}, ink_width));
  std::vector<int> shared;
  const std::vector<int> of_body = corners_of(after, 0);
  const std::set<int> in_body(of_body.begin(), of_body.end());
  for (const int v : corners_of(after, 1))
    if (in_body.count(v) != 0) shared.push_back(v);
  ASSERT_GT(shared.size(), 20U);
  double most = 0;
  for (size_t v = 0; v < after.positions.size(); ++v) {
    const Point3 p = before->positions[v];
    double near = 1e9;
    for (const int s : shared)
      near = std::min(near, distance({p.x, p.y}, {before->positions[s].x, before->positions[s].y}));
    const double went = p.z - after.positions[v].z;
    most = std::max(most, went);
    // Flat at the join: a step there would be a gap that shows when the model is turned.
    EXPECT_LE(went, 2 * near * near / ink_width) << near;
  }
  EXPECT_GT(most, 2 * ink_width);
}

TEST(InkRims, PartsWithoutInkStay) {
  const Model before = model_of({inked_ball});
  for (const double broad : {0.0, 60.0}) {
    Model after = before;
    narrow_inked_rims(after, drawn({inked_ball}, broad));
    EXPECT_TRUE(after.positions == before.positions) << broad;
    EXPECT_EQ(after.triangles, before.triangles) << broad;
  }
}

TEST(InkRims, AnEyeBesideAnOutlineIsNoInk) {
  const Drawing drawing = drawn({inked_ball}, ink_width);
  Drawing eyed = drawing;
  for (int y = 0; y < canvas_height; ++y)
    for (int x = 0; x < canvas_width; ++x) {
      const Point2 p = Point2{x + 0.5, y + 0.5} - inked_ball.centre;
      const double inside = inked_ball.radius - norm(p);
      if (inside > 7.5 && inside < 10.5 && p.x > 2 * std::abs(p.y))
        std::fill_n(&eyed.rgba.at(x, y), 3, 0);
    }
  Model plain = model_of({inked_ball});
  Model seeing = plain;
  narrow_inked_rims(plain, drawing);
  narrow_inked_rims(seeing, eyed);
  EXPECT_TRUE(seeing.positions == plain.positions);
}

TEST(InkRims, DarkPaintAtAnOutlineIsNoBroaderInk) {
  constexpr double thin = 2;
  Drawing drawing = drawn({inked_ball}, thin);
  for (int y = 0; y < canvas_height; ++y)
    for (int x = 0; x < canvas_width; ++x) {
      const Point2 p = Point2{x + 0.5, y + 0.5} - inked_ball.centre;
      const double inside = inked_ball.radius - norm(p);
      if (inside > 0 && inside < 11 && std::abs(p.y) > 1.7 * std::abs(p.x))
        std::fill_n(&drawing.rgba.at(x, y), 3, 20);
    }
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawing);
  EXPECT_FALSE(after.positions == before.positions);
  for (size_t v = 0; v < before.positions.size(); ++v) {
    const double r = distance(place(before.positions[v]), inked_ball.centre);
    if (r < inked_ball.radius - 16 * thin) {
      EXPECT_EQ(after.positions[v].z, before.positions[v].z);
    }
  }
}

TEST(InkRims, InkBetweenPartsLiesOnWhatIsBelow) {
  const Drawing drawing = drawn({inked_ball, nearer}, ink_width);
  const Model before = model_of({inked_ball, nearer});
  Model after = before;
  narrow_inked_rims(after, drawing);
  int moved = 0;
  for (const int v : corners_of(after, 1)) {
    const double was = before.positions[v].z;
    const double r = distance(place(after.positions[v]), inked_ball.centre);
    if (r > inked_ball.radius - 8 * ink_width) continue;
    const double below = disc_height(inked_ball, place(after.positions[v]));
    EXPECT_GE(after.positions[v].z, std::min(was, below) - 1e-9);
    if (!is_dark(drawing, after.uvs[v])) continue;
    EXPECT_LE(after.positions[v].z, std::max(nearer.lift, below) + ink_width);
    moved += after.positions[v].z < was ? 1 : 0;
  }
  EXPECT_GT(moved, 0);
}

TEST(InkRims, WhatEndsNearARimGoesBackWithIt) {
  // Touches the ball with all of its outline, within reach of the ball's ink.
  const double radius = 73;
  const Disc cap{inked_ball.centre, radius, 1,
                 std::sqrt(inked_ball.radius * inked_ball.radius - radius * radius)};
  const Model before = model_of({inked_ball, cap});
  Model after = before;
  narrow_inked_rims(after, drawn({inked_ball, cap}, ink_width));
  std::map<std::pair<double, double>, int> below;
  for (const int v : corners_of(before, 0))
    below[{before.positions[v].x, before.positions[v].y}] = v;
  int touching = 0;
  for (const int v : corners_of(before, 1)) {
    const Point3 p = before.positions[v];
    const auto at = below.find({p.x, p.y});
    if (at == below.end() || std::abs(before.normals[v].z) > 1e-6) continue;
    const Point3 ball = after.positions[at->second];
    EXPECT_LT(ball.z, p.z - 5);
    EXPECT_NEAR(after.positions[v].z, ball.z, 0.2 * (p.z - ball.z));
    ++touching;
  }
  EXPECT_GT(touching, 0);
}

}  // namespace
}  // namespace relievo::relief
