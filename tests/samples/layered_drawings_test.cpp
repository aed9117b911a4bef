#include <gtest/gtest.h>

#include <filesystem>

#include "relief/maps/relief_maps.h"
#include "samples/drawing_relief.h"
#include "support/mesh_checks.h"

namespace relievo {
namespace {

using namespace testing;

/// Intersection over union of the relief's silhouette and the drawing's opaque pixels.
double silhouette_overlap(const DrawnRelief& drawn) {
  const int width = static_cast<int>(drawn.scene.width);
  const int height = static_cast<int>(drawn.scene.height);
  const auto maps = relief::rasterize_relief(
      {drawn.relief.layers, drawn.relief.inflation, drawn.relief.ordering, drawn.scene}, width,
      height);
  EXPECT_TRUE(maps.ok());
  if (!maps.ok()) return 0;
  double both = 0;
  double either = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool drawn_here = drawn.drawing.rgba.at(x, y, 3) >= 128;
      const bool raised_here = maps->part.at(x, y) >= 0;
      both += drawn_here && raised_here ? 1 : 0;
      either += drawn_here || raised_here ? 1 : 0;
    }
  return both / either;
}

TEST(LayeredDrawings, BecomeReliefsOfThemselves) {
  const std::filesystem::path folder = RELIEVO_SHARED_DATA "/layered";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared drawings are not here";
  relief::ReliefOptions options;
  options.layers.vertex_budget = 20000;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".svg" && !entry.is_directory()) continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++count;
    const DrawnRelief drawn = relief_of(entry.path().string(), options);
    EXPECT_GE(silhouette_overlap(drawn), 0.995);
    const Manifoldness m = check_manifold(drawn.relief.layers);
    EXPECT_EQ(m.repeated_edges, 0);
    EXPECT_EQ(m.bow_ties, 0);
    EXPECT_LE(drawn.relief.ordering.report.stationarity, 1e-12);
    EXPECT_EQ(drawn.relief.ordering.max_violation, 0);
  }
  EXPECT_EQ(count, 12);
}

}  // namespace
}  // namespace relievo
