#include <gtest/gtest.h>

#include "relief/pipeline/build_relief.h"
#include "support/mesh_checks.h"
#include "support/polygon_corpus.h"
#include "support/random_scene.h"

namespace relievo {
namespace {

using namespace testing;

/// Builds with few vertices and checks everything that must hold of any relief.
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

/// A scene of the given outlines, scaled onto the canvas; rings without area are left out.
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

/// Once as one part with holes, once with every ring a part of its own.
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
}  // namespace relievo
