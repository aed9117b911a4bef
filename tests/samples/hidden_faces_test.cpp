#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "relief/finish/fill_triangle.h"
#include "relief/surface/assemble_model.h"
#include "relievo/image.h"
#include "samples/drawing_relief.h"

namespace relievo {
namespace {

using namespace testing;

constexpr int side = 500;  ///< pixels along the longer side of the canvas

/// The foremost heights of a model seen from the front, in pixels; -infinity where it is not.
Image<double> front_heights(const Model& model) {
  const double scale = side / std::max(model.width, model.height);
  const ImageSize size{side, side};
  Image<double> heights(side, side, 1, -std::numeric_limits<double>::infinity());
  for (const auto& triangle : model.triangles) {
    std::array<Point2, 3> corners;
    std::array<double, 3> z{};
    for (size_t k = 0; k < 3; ++k) {
      const Point3 p = scale * model.positions[triangle[k]];
      corners[k] = {p.x, p.y};
      z[k] = p.z;
    }
    const auto [a, b, c] = corners;
    relief::for_each_pixel_inside(corners, size, [&, a = a, b = b, c = c](int x, int y) {
      const Point2 p{x + 0.5, y + 0.5};
      const double area = cross(b - a, c - a);
      const double at_b = cross(p - a, c - a) / area;
      const double at_c = cross(b - a, p - a) / area;
      double& height = heights.at(x, y);
      height = std::max(height, (1 - at_b - at_c) * z[0] + at_b * z[1] + at_c * z[2]);
    });
  }
  return heights;
}

/// Where the model with what is hidden lies more than 0.1 pixels in front of the one without.
int pixels_in_front(const DrawnRelief& drawn) {
  const auto heights = [&](Visibility visibility) {
    const auto model = relief::assemble_model(
        {drawn.relief.layers, drawn.relief.inflation, drawn.relief.ordering, drawn.scene},
        {visibility});
    EXPECT_TRUE(model.ok());
    return front_heights(*model);
  };
  const Image<double> seen = heights(Visibility::relief);
  const Image<double> all = heights(Visibility::all);
  int count = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) count += all.at(x, y) > seen.at(x, y) + 0.1 ? 1 : 0;
  return count;
}

void expect_nothing_in_front(const std::filesystem::path& path) {
  SCOPED_TRACE(path.filename().string());
  EXPECT_EQ(pixels_in_front(relief_of(path.string(), relief::ReliefOptions())), 0);
}

TEST(HiddenFaces, LieBehindWhatIsSeenOfTheSamples) {
  for (const auto& entry : std::filesystem::directory_iterator(RELIEVO_EXAMPLES))
    if (entry.path().extension() == ".svg") expect_nothing_in_front(entry.path());
}

TEST(HiddenFaces, LieBehindWhatIsSeenOfLayeredDrawings) {
  const std::filesystem::path folder = RELIEVO_SHARED_DATA "/layered";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared drawings are not here";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".svg" || entry.is_directory())
      expect_nothing_in_front(entry.path());
}

TEST(HiddenFaces, AreLeftOutOnlyWhereTheyCross) {
  relief::ReliefOptions options;
  options.layers.vertex_budget = 20000;
  DrawnRelief drawn = relief_of(RELIEVO_EXAMPLES "/bunny.svg", options);
  std::vector<int>& crossing = drawn.relief.ordering.crossing;
  EXPECT_LT(crossing.size(), drawn.relief.layers.faces.size() / 50);
  crossing.clear();
  EXPECT_GT(pixels_in_front(drawn), 100) << "along the rims of its hollow ears";
}

}  // namespace
}  // namespace relievo
