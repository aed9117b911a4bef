#include <gtest/gtest.h>

#include <algorithm>

#include "io/mesh/stl_encode.h"
#include "io/support/byte_reader.h"
#include "support/sample_models.h"

namespace relievo {
namespace {

struct StlTriangle {
  Point3 normal;
  std::array<Point3, 3> corners;
};

std::vector<StlTriangle> parse_stl(const Bytes& bytes) {
  ByteReader reader(bytes);
  EXPECT_NE(reader.take_text(80).substr(0, 5), "solid");
  std::vector<StlTriangle> triangles(reader.take<uint32_t>());
  const auto take_point = [&] {
    const double x = reader.take<float>();
    const double y = reader.take<float>();
    const double z = reader.take<float>();
    return Point3{x, y, z};
  };
  for (StlTriangle& triangle : triangles) {
    triangle.normal = take_point();
    for (Point3& corner : triangle.corners) corner = take_point();
    EXPECT_EQ(reader.take<uint16_t>(), 0);
  }
  EXPECT_TRUE(reader.at_end());
  return triangles;
}

TEST(Stl, LiesInThePositiveOctantAtItsSize) {
  Model model = split_hemisphere(10);
  for (Point3& p : model.positions) p.z -= 30;
  Point3 low{1e9, 1e9, 1e9};
  Point3 high{-1e9, -1e9, -1e9};
  for (const StlTriangle& triangle : parse_stl(*encode_stl(model, 60)))
    for (const Point3 p : triangle.corners) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  EXPECT_EQ(low, (Point3{0, 0, 0}));
  EXPECT_NEAR(high.x, 60, 1e-4);
  EXPECT_NEAR(high.y, 60, 1e-4);
  EXPECT_NEAR(high.z, 30, 1e-4);
}

TEST(Stl, TrianglesAndNormalsFollowTheModel) {
  const Model model = split_hemisphere(10);
  const std::vector<StlTriangle> triangles = parse_stl(*encode_stl(model, 20));
  ASSERT_EQ(triangles.size(), model.triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const Point3 expected = model.positions[model.triangles[t][k]] - Point3{2.5, 2.5, 0};
      ASSERT_LT(norm(triangles[t].corners[k] - expected), 1e-5);
    }
    const Point3 outwards = triangles[t].corners[0] - Point3{10, 10, 0};
    ASSERT_NEAR(norm(triangles[t].normal), 1, 1e-5);
    ASSERT_GT(dot(triangles[t].normal, outwards), 0);
  }
}

TEST(Stl, SameModelGivesSameBytes) {
  EXPECT_EQ(*encode_stl(hemisphere(4)), *encode_stl(hemisphere(4)));
}

}  // namespace
}  // namespace relievo
