
#include "relief/surface/assemble_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/analytic_discs.h"
#include "support/model_checks.h"

namespace relievo::relief {
namespace {

const Disc ball{{100, 90}, 60};

/// One disc whose right half is a second part on the same surface, as after a join.
DiscRelief joined_halves() {
  DiscRelief relief = make_discs({ball}, 200, 180, 6);
  relief.scene.parts.push_back({"right", relief.scene.parts[0].outline, 4, 1});
  relief.mesh.part_count = 2;
  for (size_t f = 0; f < relief.mesh.faces.size(); ++f) {
    double x = 0;
    for (const int n : relief.mesh.faces[f])
      x += relief.mesh.vertices[relief.mesh.node_vertex[n]].x;
    if (x > 3 * ball.centre.x) relief.mesh.face_part[f] = 1;
  }
  return relief;
}

/// A bowl in a ball, its rim exactly on the ball.
DiscRelief bowl_in_ball(double rise = 0) {
  const double rim = std::sqrt(60.0 * 60 - 30 * 30);
  return make_discs({ball, {{100, 90}, 30, -1, rim + rise}}, 200, 180, 6);
}

TEST(AssembleModel, DiscIsOneManifoldSheetOpenAtItsOutline) {
  const DiscRelief relief = make_discs({ball}, 200, 180, 6);
  for (const Visibility visibility : {Visibility::relief, Visibility::orbit, Visibility::all}) {
    const Model model = assemble(relief, visibility);
    for (const bool merge : {false, true}) {
      const EdgeCensus census = count_edges(model, merge);
      EXPECT_EQ(census.crowded, 0);
      EXPECT_EQ(census.repeated, 0);
      EXPECT_EQ(census.open, static_cast<int>(relief.scene.parts[0].outline[0].size()));
      EXPECT_EQ(static_cast<int>(model.positions.size()) - census.edges +
                    static_cast<int>(model.triangles.size()),
                1);
    }
    for (const auto& [a, b] : count_edges(model, true).open_edges) {
      EXPECT_EQ(model.positions[a].z, 0);
      EXPECT_EQ(model.positions[b].z, 0);
    }
  }
}

TEST(AssembleModel, FrontIsTheDrawingCounterClockwise) {
  const DiscRelief relief = make_discs({ball}, 200, 180, 6);
  const Model model = assemble(relief);
  const double polygon = signed_area(relief.scene.parts[0].outline[0]);
  EXPECT_NEAR(front_area(model, model.triangles), polygon, 1e-9 * polygon);
  for (const auto& t : model.triangles) EXPECT_GT(front_area(model, {t}), 0);
  const size_t nodes = relief.mesh.node_vertex.size();
  for (size_t v = 0; v < nodes; ++v) {
    const Point3 p = model.positions[v];
    const bool found = std::any_of(relief.mesh.vertices.begin(), relief.mesh.vertices.end(),
                                   [p](Point2 q) { return q.x == p.x && 180 - q.y == p.y; });
    EXPECT_TRUE(found);
  }
}

TEST(AssembleModel, DepartsLessThanTheToleranceFromTheRoot) {
  const DiscRelief relief = make_discs({{{100, 90}, 60, 1.5, 3, {0.2, -0.1}}}, 200, 180, 12);
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1.0, 0.25, 0.05}) {
    ModelOptions options;
    options.rim_tolerance = tolerance;
    const double worst = worst_departure(assemble(relief, options), relief, 0);
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, 0.2 * tolerance);
    EXPECT_LT(worst, before);
    before = worst;
  }
}

TEST(AssembleModel, BowlsAndChangesOfSignKeepTheTolerance) {
  DiscRelief relief = make_discs({{{100, 90}, 60, -1}}, 200, 180, 12);
  EXPECT_LE(worst_departure(assemble(relief), relief, 0), 0.25);
  set_linear_heights(relief, {-3317, {31, 3}}, {1, {0.3, 0.2}});
  const Model model = assemble(relief);
  EXPECT_LE(worst_departure(model, relief, 0), 0.25);
  EXPECT_EQ(count_edges(model, false).crowded, 0);
  EXPECT_EQ(count_edges(model, false).repeated, 0);
  for (const auto& t : model.triangles) EXPECT_GT(front_area(model, {t}), 0);
}

TEST(AssembleModel, PiecesOfAFaceAreLimited) {
  const DiscRelief relief = make_discs({ball}, 200, 180, 12);
  const size_t faces = relief.mesh.faces.size();
  ModelOptions options;
  options.max_rim_levels = 0;
  EXPECT_EQ(assemble(relief, options).triangles.size(), faces);
  options.max_rim_levels = 1;
  const size_t some = assemble(relief, options).triangles.size();
  options.max_rim_levels = 4;
  const size_t all = assemble(relief, options).triangles.size();
  EXPECT_GT(some, faces);
  EXPECT_LE(some, 4 * faces);
  EXPECT_GT(all, some);
}

TEST(AssembleModel, NormalsAreThoseOfTheHemisphere) {
  const Model model = assemble(make_discs({ball}, 200, 180, 6));
  const Point3 centre{100, 180 - 90, 0};
  double worst = 0;
  for (size_t v = 0; v < model.positions.size(); ++v) {
    const Point3 n = model.normals[v];
    EXPECT_NEAR(norm(n), 1, 1e-12);
    const double cosine = dot(n, normalized(model.positions[v] - centre));
    worst = std::max(worst, std::acos(std::min(1.0, cosine)));
    if (model.positions[v].z == 0) {
      EXPECT_EQ(n.z, 0);
    }
  }
  EXPECT_LT(worst * 180 / 3.14159265358979, 0.25);
}

TEST(AssembleModel, NormalsOfBowlsFaceTheViewerAndInwards) {
  const Model model = assemble(make_discs({{{100, 90}, 60, -1}}, 200, 180, 6));
  const Point3 centre{100, 180 - 90, 0};
  for (size_t v = 0; v < model.positions.size(); ++v) {
    EXPECT_GE(model.normals[v].z, 0);
    EXPECT_GT(dot(model.normals[v], normalized(centre - model.positions[v])), 0.999);
  }
}

TEST(AssembleModel, NormalsOfTiltedPlanesAreExact) {
  DiscRelief relief = make_discs({ball}, 200, 180, 12);
  set_linear_heights(relief, {0, {0, 0}}, {5, {0.75, 0}});
  for (const Point3 n : assemble(relief).normals) EXPECT_EQ(n, (Point3{0, 0, 1}));
  set_linear_heights(relief, {16, {0, 0}}, {5, {0.75, 1}});
  const Point3 expected = normalized({-0.75, 1, 1});
  for (const Point3 n : assemble(relief).normals) EXPECT_NEAR(norm(n - expected), 0, 1e-15);
}

TEST(AssembleModel, TextureCoordinatesAreThePlaceOnTheDrawing) {
  const DiscRelief relief = make_discs({ball}, 200, 180, 6);
  const Model model = assemble(relief);
  ASSERT_EQ(model.uvs.size(), model.positions.size());
  for (size_t v = 0; v < model.uvs.size(); ++v) {
    EXPECT_EQ(model.uvs[v].x, model.positions[v].x / 200);
    EXPECT_NEAR(model.uvs[v].y, (180 - model.positions[v].y) / 180, 1e-15);
  }
}

TEST(AssembleModel, JoinedPartsShareVerticesAndKeepTheirRuns) {
  const DiscRelief relief = joined_halves();
  const Model model = assemble(relief);
  ASSERT_EQ(model.parts.size(), 2);
  EXPECT_EQ(model.parts[0].id, "disc0");
  EXPECT_EQ(model.parts[1].id, "right");
  EXPECT_EQ(model.parts[0].first_triangle, 0);
  EXPECT_EQ(model.parts[1].first_triangle, model.parts[0].triangle_count);
  EXPECT_EQ(model.parts[0].triangle_count + model.parts[1].triangle_count,
            static_cast<int>(model.triangles.size()));
  for (const int part : {0, 1})
    for (const auto& t : sheet_triangles(model, part)) {
      const double x = model.positions[t[0]].x + model.positions[t[1]].x + model.positions[t[2]].x;
      EXPECT_TRUE((x > 300) == (part == 1) || std::abs(x - 300) < 18);
    }
  const DiscRelief whole = make_discs({ball}, 200, 180, 6);
  EXPECT_EQ(count_edges(model, false).open, count_edges(assemble(whole), false).open);
  EXPECT_EQ(model.positions.size(), assemble(whole).positions.size());
}

TEST(AssembleModel, PartsWithoutVisibleTrianglesHaveEmptyRuns) {
  const DiscRelief relief = make_discs({{{100, 90}, 30}, {{100, 90}, 60}}, 200, 180, 6);
  const Model front = assemble(relief);
  EXPECT_EQ(front.parts[0].triangle_count, 0);
  EXPECT_EQ(front.parts[1].triangle_count, static_cast<int>(front.triangles.size()));
  EXPECT_GT(assemble(relief, Visibility::orbit).parts[0].triangle_count, 0);
}

TEST(AssembleModel, OrbitDropsWhatLiesUnderAReversedPart) {
  const DiscRelief relief = bowl_in_ball();
  const double ball_area = signed_area(relief.scene.parts[0].outline[0]);
  const double bowl_area = signed_area(relief.scene.parts[1].outline[0]);
  const auto area = [](const Model& model, int part) {
    return front_area(model, sheet_triangles(model, part));
  };
  const Model orbit = assemble(relief, Visibility::orbit);
  EXPECT_NEAR(area(orbit, 0), ball_area - bowl_area, 1e-8);
  EXPECT_NEAR(area(orbit, 1), bowl_area, 1e-8);
  const Model all = assemble(relief, Visibility::all);
  EXPECT_NEAR(area(all, 0), ball_area, 1e-8);
  EXPECT_NEAR(area(all, 1), bowl_area, 1e-8);
  double lowest = 0;
  for (const auto& t : sheet_triangles(orbit, 1))
    for (const int v : t)
      lowest = std::max(lowest, disc_height(ball, {100, 90}) - orbit.positions[v].z);
  EXPECT_GT(lowest, 30);
}

TEST(AssembleModel, ReversedPartIsSealedIntoTheSurfaceAroundIt) {
  for (const Visibility visibility : {Visibility::relief, Visibility::orbit})
    for (const double rise : {0.0, 4.0, -4.0}) {
      const DiscRelief relief = bowl_in_ball(rise);
      const Model model = assemble(relief, visibility);
      const EdgeCensus census = count_edges(model, true);
      EXPECT_EQ(census.open, static_cast<int>(relief.scene.parts[0].outline[0].size()));
      EXPECT_EQ(census.crowded, 0);
      const bool walls = sheet_triangles(model).size() < model.triangles.size();
      EXPECT_EQ(walls, rise != 0);
    }
}

TEST(AssembleModel, EverythingUnderAReversedPartIsDroppedNothingAboveIt) {
  const DiscRelief relief = make_discs(
      {{{100, 90}, 70}, {{100, 90}, 60}, {{100, 90}, 40, -1, 40}, {{100, 90}, 20, 1, 50}}, 200, 180,
      6);
  const auto ring_area = [&relief](int part) {
    return signed_area(relief.scene.parts[part].outline[0]);
  };
  const Model model = assemble(relief, Visibility::orbit);
  EXPECT_NEAR(front_area(model, sheet_triangles(model, 0)), ring_area(0) - ring_area(2), 1e-8);
  EXPECT_NEAR(front_area(model, sheet_triangles(model, 1)), ring_area(1) - ring_area(2), 1e-8);
  EXPECT_NEAR(front_area(model, sheet_triangles(model, 2)), ring_area(2), 1e-8);
  EXPECT_NEAR(front_area(model, sheet_triangles(model, 3)), ring_area(3), 1e-8);
}

TEST(AssembleModel, SameInputGivesTheSameBytes) {
  const DiscRelief relief = make_discs({ball, {{150, 90}, 30, 1, 20}}, 200, 180, 6);
  EXPECT_EQ(model_bytes(assemble(relief)), model_bytes(assemble(relief)));
}

TEST(AssembleModel, ScalesWithTheDrawing) {
  const double scale = 8;
  const std::vector<Disc> discs{ball, {{150, 90}, 30, 1, 20, {0.1, 0}}};
  std::vector<Disc> large = discs;
  for (Disc& disc : large)
    disc = {scale * disc.centre, scale * disc.radius, disc.d, scale * disc.lift, disc.slope};
  ModelOptions options;
  const Model small_model = assemble(make_discs(discs, 200, 180, 6), options);
  options.rim_tolerance *= scale;
  const Model large_model =
      assemble(make_discs(large, scale * 200, scale * 180, scale * 6), options);
  ASSERT_EQ(small_model.triangles, large_model.triangles);
  for (size_t v = 0; v < small_model.positions.size(); ++v) {
    EXPECT_NEAR(norm(scale * small_model.positions[v] - large_model.positions[v]), 0, 1e-9);
    EXPECT_NEAR(norm(small_model.normals[v] - large_model.normals[v]), 0, 1e-9);
  }
}

TEST(AssembleModel, RefusesWhatItCannotDo) {
  const DiscRelief relief = make_discs({ball}, 200, 180, 12);
  const auto code = [&relief](ModelOptions options, const RunContext& context = {}) {
    const auto model = assemble_model(
        {relief.mesh, relief.inflation, relief.ordering, relief.scene}, options, context);
    EXPECT_FALSE(model.ok());
    return model.ok() ? ErrorCode::internal : model.error().code;
  };
  ModelOptions options;
  for (const double tolerance : {0.0, -1.0, 1e-9, std::nan("")}) {
    options.rim_tolerance = tolerance;
    EXPECT_EQ(code(options), ErrorCode::usage);
  }
  options = {};
  options.max_rim_levels = 9;
  EXPECT_EQ(code(options), ErrorCode::usage);
  const std::atomic<bool> cancel = true;
  RunContext context;
  context.cancel = &cancel;
  EXPECT_EQ(code({}, context), ErrorCode::interrupted);
}

TEST(AssembleModel, RefusesHeightsThatAreNotFiniteAndTooManyTriangles) {
  DiscRelief relief = make_discs({ball}, 200, 180, 3);
  ModelOptions options;
  options.max_rim_levels = 8;
  options.rim_tolerance = 1e-6;
  set_linear_heights(relief, {0, {1e15, 0}}, {});
  auto model =
      assemble_model({relief.mesh, relief.inflation, relief.ordering, relief.scene}, options);
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().code, ErrorCode::limit);
  relief.inflation.u[7] = std::numeric_limits<double>::quiet_NaN();
  model = assemble_model({relief.mesh, relief.inflation, relief.ordering, relief.scene}, {});
  ASSERT_FALSE(model.ok());
  EXPECT_EQ(model.error().code, ErrorCode::internal);
  EXPECT_EQ(model.error().where, "disc0");
}

}  // namespace
}  // namespace relievo::relief
