#include "relief/maps/ambient_occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace relievo::relief {
namespace {

/// Maps of a surface z(x, y), `pixel` long and wide each, normals by differences.
ReliefMaps maps_of(int size, double pixel, const std::function<double(double, double)>& z) {
  ReliefMaps maps{ImageF(size, size, 1), ImageF(size, size, 3), Image<int32_t>(size, size, 1)};
  const double h = 1e-4;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double u = (x + 0.5) * pixel;
      const double v = (y + 0.5) * pixel;
      maps.height.at(x, y) = static_cast<float>(z(u, v));
      const double a = -(z(u + h, v) - z(u - h, v)) / (2 * h);
      const double b = (z(u, v + h) - z(u, v - h)) / (2 * h);
      const double length = std::sqrt(a * a + b * b + 1);
      maps.normal.at(x, y, 0) = static_cast<float>(a / length);
      maps.normal.at(x, y, 1) = static_cast<float>(b / length);
      maps.normal.at(x, y, 2) = static_cast<float>(1 / length);
    }
  return maps;
}

TEST(AmbientOcclusion, APlaneSeesItsWholeHemisphere) {
  for (const double slope : {0.0, 0.5, 2.0}) {
    const ImageF open = ambient_occlusion(
        maps_of(101, 3, [&](double x, double y) { return slope * x - 0.3 * slope * y; }), 3);
    for (const float share : open.pixels) ASSERT_NEAR(share, 1, 0.01) << slope;
  }
}

/// A wall of a groove that goes on for ever sees directions from its own plane to that of the
/// other: (1 - cos(angle between them)) / 2 of the light.
TEST(AmbientOcclusion, OfAGrooveIsThatOfItsAngle) {
  const int size = 400;
  for (const double slope : {0.5, 1.0, 2.0}) {
    const ImageF open = ambient_occlusion(
        maps_of(size, 0.5, [&](double x, double) { return slope * std::abs(x - 100); }), 0.5);
    const double angle = std::numbers::pi - 2 * std::atan(slope);
    EXPECT_NEAR(open.at(size / 2 + 1, size / 2), (1 - std::cos(angle)) / 2, 0.03) << slope;
  }
}

TEST(AmbientOcclusion, DoesNotDependOnTheUnitOrTheBackground) {
  const auto bump = [](double x, double y) { return std::sin(x / 3) * std::cos(y / 4); };
  const ReliefMaps small = maps_of(64, 1, bump);
  const ReliefMaps large =
      maps_of(64, 10, [&](double x, double y) { return 10 * bump(x / 10, y / 10); });
  const ImageF a = ambient_occlusion(small, 1);
  const ImageF b = ambient_occlusion(large, 10);
  for (size_t i = 0; i < a.pixels.size(); ++i) ASSERT_NEAR(a.pixels[i], b.pixels[i], 1e-3);

  ReliefMaps holed = maps_of(64, 1, [](double, double) { return 0.0; });
  holed.height.at(20, 20) = std::numeric_limits<float>::quiet_NaN();
  for (const float share : ambient_occlusion(holed, 1).pixels) EXPECT_NEAR(share, 1, 1e-6);
}

}  // namespace
}  // namespace relievo::relief
