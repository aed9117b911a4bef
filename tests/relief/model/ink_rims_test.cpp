#include "relief/model/ink_rims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "relief/model/assemble_model.h"
#include "support/analytic_discs.h"
#include "support/model_checks.h"

namespace relievo {
namespace {

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

TEST(InkRims, InkReachesHalfAsDeepAndPaintTheRest) {
  const Drawing drawing = drawn({inked_ball}, ink_width);
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawing);
  // On a ball of radius R ink of width w reaches sqrt(2 R w - w^2) deep.
  const double deep = std::sqrt(2 * inked_ball.radius * ink_width - ink_width * ink_width);
  EXPECT_NEAR(depth_of_ink(before, drawing), deep, 0.2 * deep);
  EXPECT_LT(depth_of_ink(after, drawing), 0.55 * deep);
}

TEST(InkRims, FrontStaysAsDrawn) {
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawn({inked_ball}, ink_width));
  const size_t walls = after.triangles.size() - before.triangles.size();
  ASSERT_GT(walls, 0U);
  for (size_t t = 0; t < before.triangles.size(); ++t)
    EXPECT_EQ(after.triangles[walls + t], before.triangles[t]);
  for (size_t v = 0; v < before.positions.size(); ++v) {
    EXPECT_EQ(after.positions[v].x, before.positions[v].x);
    EXPECT_EQ(after.positions[v].y, before.positions[v].y);
    EXPECT_GE(after.positions[v].z, before.positions[v].z);
    EXPECT_TRUE(after.normals[v] == before.normals[v]);
    EXPECT_TRUE(after.uvs[v] == before.uvs[v]);
    const double r = distance({before.positions[v].x, before.positions[v].y},
                              {inked_ball.centre.x, canvas_height - inked_ball.centre.y});
    if (r < inked_ball.radius - 4 * ink_width) {
      EXPECT_EQ(after.positions[v].z, before.positions[v].z);
    }
  }
  for (size_t t = 0; t < walls; ++t) {
    const auto [a, b, c] = after.triangles[t];
    const Point3 p = after.positions[a];
    const Point3 n = cross(after.positions[b] - p, after.positions[c] - p);
    EXPECT_NEAR(n.z, 0, 1e-9);
    EXPECT_GE(dot(n, after.normals[a]), 0);
  }
}

TEST(InkRims, WallsStandOnTheOldOutlineAndEndAtTheNewOne) {
  const Model before = model_of({inked_ball});
  Model after = before;
  narrow_inked_rims(after, drawn({inked_ball}, ink_width));
  const size_t walls = after.triangles.size() - before.triangles.size();
  std::map<std::pair<double, double>, std::pair<double, double>> column;
  for (size_t v = 0; v < before.positions.size(); ++v) {
    const Point3 p = before.positions[v];
    column[{p.x, p.y}] = {p.z, after.positions[v].z};
  }
  for (size_t t = 0; t < walls; ++t)
    for (const int v : after.triangles[t]) {
      const Point3 p = after.positions[v];
      const auto [foot, top] = column.at({p.x, p.y});
      EXPECT_LT(std::min(std::abs(p.z - foot), std::abs(p.z - top)), 1e-9);
    }
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

TEST(InkRims, NothingMovesBelowOtherParts) {
  const Model before = model_of({inked_ball, nearer});
  Model after = before;
  narrow_inked_rims(after, drawn({inked_ball, nearer}, ink_width));
  const ModelPart& part = before.parts[0];
  int moved = 0;
  for (int t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    for (const int v : before.triangles[t]) {
      const Point2 p{before.positions[v].x, canvas_height - before.positions[v].y};
      const bool covered = distance(p, nearer.centre) < nearer.radius;
      if (covered) {
        EXPECT_TRUE(after.positions[v] == before.positions[v]) << p.x << " " << p.y;
      }
      moved += after.positions[v] == before.positions[v] ? 0 : 1;
    }
  EXPECT_GT(moved, 0);
}

}  // namespace
}  // namespace relievo
