
#include "relief/maps/relief_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/analytic_discs.h"

namespace relievo::relief {
namespace {

const Disc tilted_ball{{100, 90}, 60, 1, 5, {0.1, -0.2}};

ReliefMaps rasterize(const DiscRelief& relief, int width, int height) {
  auto maps = rasterize_relief({relief.mesh, relief.inflation, relief.ordering, relief.scene},
                               width, height);
  EXPECT_TRUE(maps.ok()) << to_string(maps.error());
  return maps.ok() ? std::move(*maps) : ReliefMaps{};
}

ErrorCode refusal(const DiscRelief& relief, int width, int height, const RunContext& context = {}) {
  const auto maps = rasterize_relief({relief.mesh, relief.inflation, relief.ordering, relief.scene},
                                     width, height, context);
  EXPECT_FALSE(maps.ok());
  return maps.ok() ? ErrorCode::internal : maps.error().code;
}

Point2 canvas_point(const DiscRelief& relief, const ReliefMaps& maps, int x, int y) {
  return {(x + 0.5) * relief.scene.width / maps.height.width,
          (y + 0.5) * relief.scene.height / maps.height.height};
}

TEST(ReliefMaps, HeightsAreThoseOfTheBallAtAnyResolution) {
  const DiscRelief relief = make_discs({tilted_ball}, 200, 180, 3);
  for (const int factor : {1, 4}) {
    const ReliefMaps maps = rasterize(relief, 200 * factor, 180 * factor);
    double squares = 0;
    double worst = 0;
    int covered = 0;
    for (int y = 0; y < maps.height.height; ++y)
      for (int x = 0; x < maps.height.width; ++x) {
        if (maps.part.at(x, y) < 0) continue;
        const double exact = disc_height(tilted_ball, canvas_point(relief, maps, x, y));
        const double error = std::abs(maps.height.at(x, y) - exact);
        squares += error * error;
        worst = std::max(worst, error);
        ++covered;
      }
    EXPECT_LT(std::sqrt(squares / covered), 0.06);
    EXPECT_LT(worst, 1.6);
  }
}

TEST(ReliefMaps, CoverExactlyTheDisc) {
  const DiscRelief relief = make_discs({tilted_ball}, 200, 180, 3);
  const ReliefMaps maps = rasterize(relief, 400, 360);
  int both = 0;
  int either = 0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 400; ++x) {
      const bool covered = maps.part.at(x, y) >= 0;
      const bool inside =
          distance(canvas_point(relief, maps, x, y), tilted_ball.centre) < tilted_ball.radius;
      EXPECT_EQ(covered, !std::isnan(maps.height.at(x, y)));
      both += covered && inside;
      either += covered || inside;
    }
  EXPECT_GT(both, 0.998 * either);
}

TEST(ReliefMaps, NormalsAreUnitAndThoseOfTheBall) {
  const DiscRelief relief = make_discs({{{100, 90}, 60}}, 200, 180, 3);
  const ReliefMaps maps = rasterize(relief, 200, 180);
  double worst = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 200; ++x) {
      const Point3 n{maps.normal.at(x, y, 0), maps.normal.at(x, y, 1), maps.normal.at(x, y, 2)};
      EXPECT_NEAR(norm(n), 1, 1e-6);
      if (maps.part.at(x, y) < 0) {
        EXPECT_EQ(n, (Point3{0, 0, 1}));
        continue;
      }
      const Point2 r = canvas_point(relief, maps, x, y) - Point2{100, 90};
      const Point3 exact =
          (1 / 60.0) * Point3{r.x, -r.y, std::sqrt(std::max(0.0, 3600 - dot(r, r)))};
      worst = std::max(worst, norm(n - exact));
    }
  EXPECT_LT(worst, 0.03);
}

TEST(ReliefMaps, PartsFollowTheOrderWhateverTheirHeight) {
  const DiscRelief relief = make_discs(
      {{{90, 100}, 60}, {{140, 100}, 50, 1, -500}, {{90, 100}, 20, -1, 30}}, 220, 200, 5);
  const ReliefMaps maps = rasterize(relief, 220, 200);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 220; ++x) {
      const Point2 p = canvas_point(relief, maps, x, y);
      int expected = -1;
      for (int i = 0; i < 3; ++i)
        if (contains(relief.scene.parts[i].outline, p)) expected = i;
      EXPECT_EQ(maps.part.at(x, y), expected) << x << ' ' << y;
    }
}

/// A square of two triangles about every pixel: corners, edges and diagonals of the base run
/// exactly through pixel centres.
DiscRelief square_grid(int cells) {
  DiscRelief relief;
  relief.scene.width = relief.scene.height = cells;
  relief.scene.parts.push_back({"grid", {}, 4, 1});
  LayeredMesh& mesh = relief.mesh;
  const int side = cells;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) mesh.vertices.push_back({x + 0.5, y + 0.5});
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int v = y * side + x;
      mesh.triangles.push_back({v, v + 1, v + side + 1});
      mesh.triangles.push_back({v, v + side + 1, v + side});
    }
  mesh.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
  mesh.part_count = 1;
  mesh.faces = mesh.triangles;
  mesh.face_part.assign(mesh.faces.size(), 0);
  for (size_t t = 0; t <= mesh.faces.size(); ++t) mesh.stack_begin.push_back(static_cast<int>(t));
  for (size_t t = 0; t < mesh.faces.size(); ++t) mesh.face_triangle.push_back(static_cast<int>(t));
  const size_t nodes = mesh.vertices.size();
  for (size_t n = 0; n < nodes; ++n) mesh.node_vertex.push_back(static_cast<int>(n));
  mesh.node_part.assign(nodes, 0);
  mesh.node_role.assign(nodes, NodeRole::interior);
  relief.inflation = {std::vector<double>(nodes), std::vector<Point2>(nodes)};
  relief.ordering.h = relief.ordering.g = std::vector<double>(nodes);
  relief.ordering.grad_g = std::vector<Point2>(nodes);
  return relief;
}

TEST(ReliefMaps, CentresOnEdgesAndVerticesBelongToOneTriangle) {
  const int cells = 9;
  DiscRelief relief = square_grid(cells);
  std::vector<int> owners(cells * cells, 0);
  const LayeredMesh whole = relief.mesh;
  for (size_t t = 0; t < whole.triangles.size(); ++t) {
    for (size_t s = 0; s <= whole.triangles.size(); ++s)
      relief.mesh.stack_begin[s] = s <= t ? 0 : 1;
    relief.mesh.faces = {whole.triangles[t]};
    relief.mesh.face_triangle = {static_cast<int>(t)};
    relief.mesh.face_part = {0};
    const ReliefMaps maps = rasterize(relief, cells, cells);
    for (size_t i = 0; i < owners.size(); ++i) owners[i] += maps.part.pixels[i] == 0;
  }
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const bool inner = x > 0 && y > 0 && x + 1 < cells && y + 1 < cells;
      if (inner) {
        EXPECT_EQ(owners[y * cells + x], 1) << x << ' ' << y;
      }
      EXPECT_LE(owners[y * cells + x], 1);
    }
}

TEST(ReliefMaps, SameInputGivesTheSameBytes) {
  const DiscRelief relief = make_discs({tilted_ball}, 200, 180, 6);
  const ReliefMaps a = rasterize(relief, 100, 90);
  const ReliefMaps b = rasterize(relief, 100, 90);
  EXPECT_EQ(std::memcmp(a.height.pixels.data(), b.height.pixels.data(),
                        a.height.pixels.size() * sizeof(float)),
            0);
  EXPECT_EQ(a.normal.pixels, b.normal.pixels);
  EXPECT_EQ(a.part.pixels, b.part.pixels);
}

TEST(ReliefMaps, PartsBeyondTheCanvasAreClipped) {
  const Disc off{{0, 170}, 60};
  const DiscRelief relief = make_discs({off}, 200, 180, 6);
  const ReliefMaps maps = rasterize(relief, 200, 180);
  EXPECT_EQ(maps.part.at(0, 179), 0);
  EXPECT_NEAR(maps.height.at(0, 170), 60, 0.3);
  EXPECT_EQ(maps.part.at(61, 170), -1);
}

TEST(ReliefMaps, RefusesSizesBeforeMemoryIsSpent) {
  const DiscRelief relief = make_discs({tilted_ball}, 200, 180, 12);
  EXPECT_EQ(refusal(relief, 0, 10), ErrorCode::usage);
  EXPECT_EQ(refusal(relief, 10, -1), ErrorCode::usage);
  EXPECT_EQ(refusal(relief, 32769, 1), ErrorCode::limit);
  EXPECT_EQ(refusal(relief, 32768, 32768), ErrorCode::limit);
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(refusal(relief, 10, 10, context), ErrorCode::interrupted);
}

TEST(ReliefMaps, RefusesVerticesOutOfReach) {
  DiscRelief relief = make_discs({tilted_ball}, 200, 180, 12);
  relief.mesh.vertices[0].x = 1e12;
  EXPECT_EQ(refusal(relief, 200, 180), ErrorCode::limit);
}

}  // namespace
}  // namespace relievo::relief
