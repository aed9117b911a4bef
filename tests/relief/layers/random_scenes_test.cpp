#include <gtest/gtest.h>

#include <algorithm>

#include "relief/session/build_relief.h"
#include "support/mesh_checks.h"
#include "support/polygon_corpus.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;

/// Builds with few vertices and checks what must hold for every relief.
void expect_sound(const Scene& scene) {
  ReliefOptions options;
  options.layers.vertex_budget = 2000;
  const auto relief = build_relief(scene, options);
  ASSERT_TRUE(relief.ok()) << to_string(relief.error());
  EXPECT_EQ(inconsistency(relief->layers), "");
  const Manifoldness m = check_manifold(relief->layers);
  EXPECT_EQ(m.repeated_edges, 0);
  EXPECT_EQ(m.bow_ties, 0);
  const BoundQpReport& report = relief->ordering.report;
  EXPECT_EQ(report.status, SolveStatus::solved);
  EXPECT_LE(report.stationarity, 1e-12);
  EXPECT_EQ(report.primal, 0);
  EXPECT_LE(report.dual, 1e-12);
  EXPECT_LE(report.complementarity, 1e-12);
  EXPECT_LE(relief->ordering.max_violation, 1e-9 * (scene.width + scene.height));
}

TEST(RandomScenes, AreManifoldAndSolved) {
  int joins = 0;
  for (uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = random_scene(seed);
    joins += static_cast<int>(scene.joins.size());
    expect_sound(scene);
  }
  EXPECT_GT(joins, 100);
}

/// Returns a random stretch of a line, in either direction.
std::vector<Point2> random_stretch(Random& random, std::vector<Point2> line) {
  const int n = static_cast<int>(line.size());
  const int first = random.integer(0, n / 3);
  const int last = n - random.integer(0, n / 3);
  line = {line.begin() + first, line.begin() + last};
  if (random.uniform(0, 1) < 0.3) std::reverse(line.begin(), line.end());
  return line;
}

/// A random scene with up to eight joins, often several between the same two parts.
Scene scene_of_many_joins(uint64_t seed) {
  Scene scene = random_scene(seed);
  scene.joins.clear();
  Random random(seed + 1000);
  const int parts = static_cast<int>(scene.parts.size());
  for (int i = random.integer(2, 8); i > 0; --i) {
    const int upper = random.integer(1, parts - 1);
    const int lower = random.integer(0, upper - 1);
    const std::vector<Point2> line =
        inside_run(scene.parts[upper].outline, scene.parts[lower].outline);
    if (!line.empty()) scene.joins.push_back({upper, lower, random_stretch(random, line)});
  }
  return scene;
}

TEST(RandomScenes, ManyJoinsAreManifoldOrRefusedByName) {
  int made = 0;
  int refused = 0;
  for (uint64_t seed = 1; seed <= 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    LayerOptions options;
    options.vertex_budget = 300 + 100 * static_cast<int>(seed % 10);
    const auto layers = layer_parts(scene_of_many_joins(seed), options);
    if (!layers) {
      EXPECT_EQ(layers.error().code, ErrorCode::bad_input);
      EXPECT_EQ(layers.error().where.substr(0, 6), "joins[");
      ++refused;
      continue;
    }
    ++made;
    EXPECT_EQ(inconsistency(*layers), "");
    const Manifoldness m = check_manifold(*layers);
    EXPECT_EQ(m.repeated_edges, 0);
    EXPECT_EQ(m.bow_ties, 0);
  }
  EXPECT_GT(made, 30);
  EXPECT_GT(refused, 3);
}

/// A part is joined to another at two places, and between them to a third part that overlaps both.
TEST(RandomScenes, JoinsOnTopOfEachOtherAreRefusedByName) {
  Scene scene = canvas();
  scene.parts = {part("back", rectangle(50, 100, 250, 300)),
                 part("middle", rectangle(100, 80, 350, 280)),
                 part("arm", rectangle(60, 160, 340, 220))};
  scene.joins = {{2, 0, {{110, 160}, {150, 160}}},
                 {2, 1, {{120, 160}, {230, 160}}},
                 {2, 0, {{140, 160}, {240, 160}}}};
  for (const int budget : {600, 2000, 10000}) {
    LayerOptions options;
    options.vertex_budget = budget;
    const auto layers = layer_parts(scene, options);
    ASSERT_FALSE(layers.ok());
    EXPECT_EQ(layers.error().code, ErrorCode::bad_input);
    EXPECT_EQ(layers.error().where.substr(0, 6), "joins[");
  }
}

TEST(RandomScenes, SpecksAreDroppedWithAWarning) {
  Scene scene = canvas();
  scene.parts = {part("plate", rectangle(80, 80, 320, 320))};
  LayerOptions options;
  options.edge_length = 5;
  const auto plain = layer_parts(scene, options);
  scene.parts[0].outline.push_back(circle({360, 360}, 1e-6));
  scene.parts[0].outline.push_back(rectangle(20, 20, 20.0001, 20.0001));
  scene.parts.push_back(part("dot", circle({200, 200}, 1e-9)));
  const auto layers = layer_parts(scene, options);
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(layers.ok()) << to_string(layers.error());
  EXPECT_EQ(layers->faces, plain->faces);
  ASSERT_EQ(layers->warnings.size(), 3);
  EXPECT_EQ(layers->warnings[0].substr(0, 30), R"(parts[0] ("plate"): 2 of its r)");
  EXPECT_EQ(layers->warnings[2].substr(0, 27), R"(parts[1] ("dot"): vanishes )");
  scene.parts = {scene.parts[1], part("dash", rectangle(9, 9, 9 + 1e-9, 300))};
  EXPECT_EQ(build_relief(scene, {}).error().code, ErrorCode::bad_input);
}

TEST(RandomScenes, ManyPartsSurviveWithFewVertices) {
  Scene scene = canvas();
  Random random(5);
  for (int i = 0; i < 300; ++i)
    scene.parts.push_back(part("part" + std::to_string(i),
                               circle({random.uniform(0, 400), random.uniform(0, 400)}, 9, 20)));
  LayerOptions options;
  options.vertex_budget = 200;
  const auto layers = layer_parts(scene, options);
  ASSERT_TRUE(layers.ok()) << to_string(layers.error());
  EXPECT_TRUE(layers->warnings.empty());
}

/// A scene of the given outlines, scaled to the canvas, without rings of no area.
Scene scene_of(const std::vector<Outline>& outlines) {
  Scene scene = canvas();
  Box2 box;
  for (const Outline& outline : outlines) box.add(bounding_box(outline));
  const double scale = 400 / std::max({box.max.x - box.min.x, box.max.y - box.min.y, 1e-300});
  for (Outline outline : outlines) {
    std::erase_if(outline, [](const Ring& ring) { return signed_area(ring) == 0; });
    for (Ring& ring : outline)
      for (Point2& p : ring) p = scale * (p - box.min);
    if (!outline.empty())
      scene.parts.push_back(Part{"part" + std::to_string(scene.parts.size()), outline, 4, 1});
  }
  return scene;
}

/// Checks each polygon once as one part with holes, and once with every ring a part of its own.
void expect_sound_both_ways(const std::vector<CorpusPolygon>& polygons) {
  constexpr size_t most_parts = 20;
  if (polygons.empty()) GTEST_SKIP() << "the shared drawings are not here";
  for (const CorpusPolygon& polygon : polygons) {
    SCOPED_TRACE(polygon.name);
    Outline nested = polygon.rings;
    orient_by_nesting(nested);
    const Scene whole = scene_of({nested});
    if (whole.parts.empty()) continue;
    expect_sound(whole);
    std::vector<Outline> apart;
    for (const Ring& ring : polygon.rings)
      if (apart.size() < most_parts) apart.push_back({ring});
    expect_sound(scene_of(apart));
  }
}

const std::string polygons = RELIEVO_SHARED_DATA "/adversarial/polygons/";

TEST(PolygonCorpus, Earcut) { expect_sound_both_ways(earcut_polygons(polygons + "earcut")); }

TEST(PolygonCorpus, Cdt) { expect_sound_both_ways(cdt_polygons(polygons + "cdt")); }

TEST(PolygonCorpus, Clipper) {
  expect_sound_both_ways(clipper_polygons(polygons + "clipper2/Polygons.txt"));
  expect_sound_both_ways(clipper_polygons(polygons + "clipper2/PolytreeHoleOwner.txt"));
}

}  // namespace
}  // namespace relievo::relief
