#include "kernel/geometry/ellipse.h"

#include <gtest/gtest.h>

#include "kernel/geometry/polyline.h"

namespace relievo {
namespace {

/// Returns points of an ellipse from parameter t0 to t1.
std::vector<Point2> arc(const Ellipse& e, double t0, double t1, int count) {
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i) {
    const double t = t0 + (t1 - t0) * i / (count - 1);
    const double u = e.a * std::cos(t);
    const double v = e.b * std::sin(t);
    const double c = std::cos(e.angle);
    const double s = std::sin(e.angle);
    points.push_back({e.centre.x + c * u - s * v, e.centre.y + s * u + c * v});
  }
  return points;
}

TEST(Ellipse, IsFoundFromTwoThirdsOfItsContour) {
  const Ellipse truth{{120, 80}, 60, 35, 0.4};
  EllipseEvidence evidence;
  evidence.on = arc(truth, 0.3, 4.5, 120);
  evidence.noise = 0.1;
  const auto found = fit_ellipse(evidence);
  ASSERT_TRUE(found);
  for (const Point2 p : arc(truth, 0, 6.28, 60))
    EXPECT_LT(std::abs(first_order_distance(*found, p)), 0.5);
}

TEST(Ellipse, IsFoundFromTwoSidesAndWhatItContains) {
  const Ellipse truth{{100, 100}, 50, 60, 0};
  EllipseEvidence evidence;
  evidence.on = arc(truth, -0.35, 0.35, 40);
  const std::vector<Point2> left = arc(truth, M_PI - 0.35, M_PI + 0.35, 40);
  evidence.on.insert(evidence.on.end(), left.begin(), left.end());
  evidence.within = {{70, 120}, {100, 115}, {130, 120}, {100, 80}};
  evidence.noise = 0.05;
  const auto found = fit_ellipse(evidence);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->a * found->b, truth.a * truth.b, 0.1 * truth.a * truth.b);
}

TEST(Ellipse, LimbIsAsLongAsItsSidesBendOnAGridOfPixels) {
  // The middle half of a limb, rounded to pixels. Distances along rays from its centre would give
  // the far points, and their rounding, too much weight and make it short.
  for (const double slope : {0.1, 0.5, 0.8}) {
    const Ellipse truth{{200, 200}, 120, 30, slope};
    EllipseEvidence evidence;
    for (const double side : {0.0, M_PI})
      for (const Point2 p : arc(truth, side + M_PI / 3, side + 2 * M_PI / 3, 100))
        evidence.on.push_back({std::round(p.x), std::round(p.y)});
    const auto found = fit_ellipse(evidence);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::max(found->a, found->b), truth.a, 0.15 * truth.a) << slope;
    EXPECT_NEAR(std::min(found->a, found->b), truth.b, 0.03 * truth.b) << slope;
  }
}

TEST(Ellipse, DistanceIsExactToFirstOrder) {
  const Ellipse ellipse{{50, 60}, 40, 10, 0.3};
  for (const double t : {0.0, 0.4, 1.0, 2.0, 3.0}) {
    const Point2 on = arc(ellipse, t, t + 1, 2)[0];
    const Point2 after = arc(ellipse, t + 1e-5, t + 1, 2)[0];
    const Point2 along = (1 / distance(on, after)) * (after - on);
    const Point2 outward{along.y, -along.x};
    for (const double offset : {-0.2, 0.2})
      EXPECT_NEAR(first_order_distance(ellipse, on + offset * outward), offset, 0.04) << t;
  }
}

TEST(Ellipse, NeedsSixPoints) {
  EllipseEvidence evidence;
  evidence.on = {{0, 0}, {1, 0}, {2, 1}, {3, 3}, {1, 4}};
  EXPECT_FALSE(fit_ellipse(evidence));
}

TEST(Ellipse, KeepsOutWhatItShouldNotContain) {
  const Ellipse truth{{100, 100}, 40, 40, 0};
  EllipseEvidence evidence;
  evidence.on = arc(truth, -0.5, 0.5, 40);
  const auto free = fit_ellipse(evidence);
  evidence.without = {{100, 70}, {90, 75}, {110, 75}};
  const auto bounded = fit_ellipse(evidence);
  ASSERT_TRUE(free && bounded);
  double worst = 0;
  for (const Point2 p : evidence.without)
    worst = std::max(worst, -first_order_distance(*bounded, p));
  EXPECT_LT(worst, 3);
}

TEST(SmoothArc, FollowsCircles) {
  for (const double half : {0.2, 0.78, 1.2, M_PI / 2}) {  // half of the arc's angle
    const auto on_circle = [](double t) {
      return DirectedPoint{{100 * std::cos(t), 100 * std::sin(t)}, {-std::sin(t), std::cos(t)}};
    };
    const DirectedPoint from = on_circle(-half);
    const DirectedPoint to = on_circle(half);
    EXPECT_NEAR(turning(from, to), 2 * half, 1e-12);
    for (const Point2 p : smooth_arc(from, to, 1)) EXPECT_NEAR(norm(p), 100, half < 0.8 ? 0.05 : 2);
  }
}

TEST(SmoothArc, IsStraightBetweenPointsInLine) {
  for (const Point2 p : smooth_arc({{0, 0}, {1, 0}}, {{50, 0}, {1, 0}}, 1)) {
    EXPECT_NEAR(p.y, 0, 1e-12);
    EXPECT_GT(p.x, 0);
    EXPECT_LT(p.x, 50);
  }
}

}  // namespace
}  // namespace relievo
