#include "solid/compress_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "relief/finish/fill_triangle.h"
#include "samples/drawing_relief.h"
#include "solid/solid_case.h"

namespace relievo {
namespace {

using namespace testing;

constexpr ImageSize pixels{512, 512};
constexpr double tenth = 0.1;

/// The normal of what is seen at every pixel, its depth times `share`; zero beside the figure.
std::vector<Point3> seen_normals(const Model& model, double share) {
  std::vector<Point3> normals(size_t{512} * 512);
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    std::array<Point3, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = model.positions[model.triangles[t][k]];
    for (Point3& corner : p) corner.z *= share;
    const Point3 normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    relief::for_each_pixel_inside(relief::corners_on_image(model, t, pixels), pixels,
                                  [&](int x, int y) { normals[size_t{512} * y + x] = normal; });
  }
  return normals;
}

/// The spread of normals in windows of 9 px, 1.8 % of the canvas, summed over the figure.
double local_contrast(const std::vector<Point3>& normals) {
  double sum = 0;
  for (int y = 4; y + 4 < 512; y += 3)
    for (int x = 4; x + 4 < 512; x += 3) {
      Point3 mean;
      double squares = 0;
      int count = 0;
      for (int j = y - 4; j <= y + 4; ++j)
        for (int i = x - 4; i <= x + 4; ++i) {
          const Point3 n = normals[size_t{512} * j + i];
          if (n == Point3{}) continue;
          mean = mean + n;
          squares += dot(n, n);
          ++count;
        }
      if (count < 20) continue;
      sum += std::sqrt(std::max(0.0, squares / count - dot(mean, mean) / count / count));
    }
  return sum;
}

double depth_of(const Model& model) {
  const Box3 box = extent(model);
  return box.max.z - box.min.z;
}

TEST(CompressHeights, KeepsLocalContrastOfTheSamples) {
  for (const char* name : {"bunny", "elephant", "farmer", "lamb", "unicorn", "wolf"}) {
    relief::ReliefOptions options;
    options.layers.vertex_budget = 12000;
    options.hidden = false;
    const DrawnRelief drawn =
        relief_of(std::string(RELIEVO_EXAMPLES) + "/" + name + ".svg", options);
    const relief::VisibleSheet sheet = sheet_of(drawn.scene, drawn.relief);
    relief::VisibleSheet compressed = sheet;
    ASSERT_TRUE(compress_heights(tenth, compressed).ok()) << name;
    EXPECT_LE(depth_of(compressed.model), tenth * depth_of(sheet.model) * (1 + 1e-9)) << name;
    EXPECT_GE(depth_of(compressed.model), 0.9 * tenth * depth_of(sheet.model)) << name;
    const double before = local_contrast(seen_normals(sheet.model, 1));
    const double linear = local_contrast(seen_normals(sheet.model, tenth)) / before;
    const double kept = local_contrast(seen_normals(compressed.model, 1)) / before;
    std::printf("%s: local contrast of normals kept %.2f, evenly %.2f\n", name, kept, linear);
    EXPECT_GT(kept, 0.7) << name;
  }
}

}  // namespace
}  // namespace relievo
