
#include "relief/inflation/inflate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "kernel/operators/laplacian.h"
#include "relief/layers/layered_mesh.h"
#include "support/solve_once.h"
#include "support/stacked_parts.h"

namespace relievo::relief {
namespace {

using testing::Cover;
using testing::node_at;
using testing::scene_of;

constexpr double radius = 200;

const Cover everywhere = [](int, Point2) { return true; };

LayeredMesh disc(int rings) { return stack_parts(testing::disc_mesh(radius, rings), {everywhere}); }

Point2 position(const LayeredMesh& mesh, size_t node) {
  return mesh.vertices[mesh.node_vertex[node]];
}

/// Puts the whole outline under one ramp with the same alpha everywhere.
void soften_outline(LayeredMesh& mesh, double alpha, double rho, double ramp_length) {
  mesh.ramps.push_back({0, 0, ramp_length, alpha, rho});
  const auto count = std::count(mesh.node_role.begin(), mesh.node_role.end(), NodeRole::outline);
  const double edge = 2 * radius * std::sin(std::numbers::pi / static_cast<double>(count));
  for (size_t n = 0; n < mesh.node_role.size(); ++n) {
    if (mesh.node_role[n] != NodeRole::outline) continue;
    mesh.node_role[n] = NodeRole::ramp;
    mesh.ramp_nodes.push_back({static_cast<int>(n), 0, -1, 0.0, edge});
  }
}

Inflation solved(const LayeredMesh& mesh, const Scene& scene,
                 const InflationOptions& options = {}) {
  const Result<Inflation> result = inflate(mesh, scene, options);
  EXPECT_TRUE(result) << to_string(result.error());
  return *result;
}

/// Returns the largest |u - (R^2 - r^2 + rise)| over the nodes, px^2.
double disc_error(const LayeredMesh& mesh, const std::vector<double>& u, double rise) {
  double worst = 0;
  for (size_t n = 0; n < u.size(); ++n) {
    const double r = norm(position(mesh, n));
    worst = std::max(worst, std::abs(u[n] - (radius * radius - r * r + rise)));
  }
  return worst;
}

/// Returns the root mean square of u - (R^2 - r^2 + rise) over the disc, px^2.
double disc_mean_error(const LayeredMesh& mesh, const std::vector<double>& u, double rise) {
  const std::vector<Point2> positions = node_positions(mesh);
  const Eigen::VectorXd mass = lumped_mass({positions, mesh.faces});
  double sum = 0;
  for (size_t n = 0; n < u.size(); ++n) {
    const double error = u[n] - (radius * radius - dot(positions[n], positions[n]) + rise);
    sum += mass[static_cast<Eigen::Index>(n)] * error * error;
  }
  return std::sqrt(sum / mass.sum());
}

TEST(Inflate, MakesADiscAHemisphere) {
  const LayeredMesh mesh = disc(24);
  const Inflation inflation = solved(mesh, scene_of(mesh));
  for (size_t n = 0; n < inflation.u.size(); ++n) {
    const double r = norm(position(mesh, n));
    const double exact = std::sqrt(std::max(0.0, radius * radius - r * r));
    EXPECT_NEAR(std::sqrt(inflation.u[n]), exact, 0.01 * radius);
  }
}

TEST(Inflate, ConvergesWithSecondOrderOnADisc) {
  double coarse = 0;
  for (const int rings : {6, 12, 24, 48}) {
    const LayeredMesh mesh = disc(rings);
    const double error = disc_error(mesh, solved(mesh, scene_of(mesh)).u, 0);
    if (coarse > 0) {
      EXPECT_GE(std::log2(coarse / error), 1.8) << rings;
    }
    coarse = error;
  }
}

/// A scene of one disc, with the outline that gives its width.
Scene flat_disc_scene(const LayeredMesh& mesh, double flat) {
  Scene scene = scene_of(mesh);
  Ring ring;
  for (int i = 0; i < 4096; ++i)
    ring.push_back({radius * std::cos(2 * std::numbers::pi * i / 4096),
                    radius * std::sin(2 * std::numbers::pi * i / 4096)});
  scene.parts[0].outline = {ring};
  scene.parts[0].flat = flat;
  return scene;
}

/// Returns the u of a flat disc. Its half-width, area / perimeter, is radius / 2.
double flat_disc_u(double flat, double r) {
  const double k = 8 * flat;
  const double level = radius * radius / (2 * (1 - 1 / std::cosh(k)));
  return level * (1 - std::cyl_bessel_i(0, 2 * k * r / radius) / std::cyl_bessel_i(0, 2 * k));
}

TEST(Inflate, ConvergesWithSecondOrderOnAFlatDisc) {
  for (const double flat : {0.1, 0.4, 1.0}) {
    double coarse = 0;
    for (const int rings : {24, 48, 96}) {
      const LayeredMesh mesh = disc(rings);
      const std::vector<double> u = solved(mesh, flat_disc_scene(mesh, flat)).u;
      double error = 0;
      for (size_t n = 0; n < u.size(); ++n)
        error = std::max(error, std::abs(u[n] - flat_disc_u(flat, norm(position(mesh, n)))));
      if (coarse > 0) {
        EXPECT_GE(std::log2(coarse / error), 1.8) << flat << " " << rings;
      }
      coarse = error;
    }
  }
}

TEST(Inflate, ABarelyFlatDiscIsRound) {
  const LayeredMesh mesh = disc(24);
  const std::vector<double> round = solved(mesh, flat_disc_scene(mesh, 0)).u;
  const std::vector<double> almost = solved(mesh, flat_disc_scene(mesh, 2e-4)).u;
  for (size_t n = 0; n < round.size(); ++n)
    EXPECT_NEAR(almost[n], round[n], 1e-5 * radius * radius);
}

TEST(Inflate, ConvergesWithSecondOrderOnASoftRim) {
  const double rho = 0.25;
  const double ramp_length = 100;
  for (const double alpha : {0.05, 0.2, 0.5, 0.9}) {
    const double rise = 2 * radius * (1 - alpha) / alpha * rho * ramp_length;
    double coarse = 0;
    for (const int rings : {6, 12, 24, 48}) {
      LayeredMesh mesh = disc(rings);
      soften_outline(mesh, alpha, rho, ramp_length);
      const std::vector<double> u = solved(mesh, scene_of(mesh)).u;
      const double error = disc_mean_error(mesh, u, rise);
      EXPECT_LE(disc_error(mesh, u, rise), 0.015 * (radius * radius + rise));
      if (coarse > 0) {
        EXPECT_GE(std::log2(coarse / error), 1.8) << alpha << " " << rings;
      }
      coarse = error;
    }
  }
}

TEST(Inflate, TakesAlphaAndRhoFromTheOptionsWhereARampHasNone) {
  LayeredMesh given = disc(8);
  soften_outline(given, 0.3, 0.4, 50);
  LayeredMesh open = disc(8);
  soften_outline(open, -1, -1, 50);
  InflationOptions options;
  options.alpha0 = 0.3;
  options.rho = 0.4;
  EXPECT_EQ(solved(given, scene_of(given)).u, solved(open, scene_of(open), options).u);
}

TEST(Inflate, AnAlphaOfOneIsAnOutline) {
  LayeredMesh mesh = disc(8);
  const std::vector<double> u = solved(mesh, scene_of(mesh)).u;
  soften_outline(mesh, 1, 0.25, 100);
  const std::vector<double> same = solved(mesh, scene_of(mesh)).u;
  for (size_t n = 0; n < u.size(); ++n) EXPECT_NEAR(same[n], u[n], 1e-12 * radius * radius);
}

TEST(Inflate, AlphaRisesLinearlyAlongARamp) {
  LayeredMesh along = disc(8);
  soften_outline(along, 0.2, 0.25, 100);
  for (RampNode& node : along.ramp_nodes) node.t = 0.5;
  LayeredMesh constant = disc(8);
  soften_outline(constant, 0.6, 0.25, 100);
  const std::vector<double> u = solved(along, scene_of(along)).u;
  const std::vector<double> expected = solved(constant, scene_of(constant)).u;
  for (size_t n = 0; n < u.size(); ++n) EXPECT_NEAR(u[n], expected[n], 1e-9 * radius * radius);
}

/// A strip of half width a along x, with natural boundaries at its ends.
LayeredMesh strip(int rows, double a) {
  LayeredMesh mesh = stack_parts(testing::grid_mesh(2 * rows, rows, 2 * a / rows), {everywhere});
  for (size_t n = 0; n < mesh.node_role.size(); ++n) {
    const double y = position(mesh, n).y;
    const bool side = y < 1e-9 * a || y > 2 * a * (1 - 1e-9);
    if (mesh.node_role[n] == NodeRole::outline && !side) mesh.node_role[n] = NodeRole::flap;
  }
  return mesh;
}

TEST(Inflate, MakesAStripRootTwoTimesItsHalfWidthHigh) {
  const double a = 30;
  const LayeredMesh mesh = strip(16, a);
  const Inflation inflation = solved(mesh, scene_of(mesh));
  for (size_t n = 0; n < inflation.u.size(); ++n) {
    const double s = position(mesh, n).y - a;
    EXPECT_NEAR(inflation.u[n], 2 * (a * a - s * s), 1e-9 * a * a);
  }
  EXPECT_NEAR(std::sqrt(*std::max_element(inflation.u.begin(), inflation.u.end())),
              std::numbers::sqrt2 * a, 1e-9 * a);
}

TEST(Inflate, GradientsAreThoseOfTheDiscUpToTheRim) {
  const LayeredMesh mesh = disc(24);
  const Inflation inflation = solved(mesh, scene_of(mesh));
  for (size_t n = 0; n < inflation.u.size(); ++n)
    EXPECT_LE(norm(inflation.grad_u[n] + 2.0 * position(mesh, n)), 0.005 * radius);
}

TEST(Inflate, NegativeDepthMirrors) {
  const LayeredMesh mesh = disc(10);
  const Inflation up = solved(mesh, scene_of(mesh, 3, 0.7));
  const Inflation down = solved(mesh, scene_of(mesh, 3, -0.7));
  for (size_t n = 0; n < up.u.size(); ++n) EXPECT_EQ(down.u[n], -up.u[n]);
}

TEST(Inflate, DepthScalesTheHeightLinearly) {
  const LayeredMesh mesh = disc(10);
  const Inflation full = solved(mesh, scene_of(mesh, 4, 1));
  const Inflation half = solved(mesh, scene_of(mesh, 4, 0.5));
  for (size_t n = 0; n < full.u.size(); ++n)
    EXPECT_NEAR(std::sqrt(half.u[n]), 0.5 * std::sqrt(full.u[n]), 1e-9 * radius);
}

TEST(Inflate, DoesNotDependOnTheSizeOfTheDrawing) {
  LayeredMesh mesh = disc(10);
  soften_outline(mesh, 0.2, 0.25, 100);
  const Inflation inflation = solved(mesh, scene_of(mesh));
  for (const double factor : {0.5, 2.0, 3.7}) {
    LayeredMesh scaled = mesh;
    for (Point2& p : scaled.vertices) p = factor * p;
    for (RobinRamp& ramp : scaled.ramps) ramp.length *= factor;
    for (RampNode& node : scaled.ramp_nodes) node.mass *= factor;
    const Inflation other = solved(scaled, scene_of(scaled));
    for (size_t n = 0; n < inflation.u.size(); ++n)
      EXPECT_NEAR(other.u[n], factor * factor * inflation.u[n],
                  1e-9 * factor * factor * radius * radius);
  }
}

TEST(Inflate, IsSmoothAcrossAJoin) {
  LayeredMesh mesh =
      stack_parts(testing::grid_mesh(100, 90, 2),
                  {testing::in_box({0, 0}, {200, 120}), testing::in_box({80, 80}, {120, 180})});
  testing::join_parts(mesh, 1, 0, [](Point2 p) { return p.y == 80 && p.x >= 80 && p.x <= 120; });
  const Inflation inflation = solved(mesh, scene_of(mesh));
  const auto height = [&](int part, int row) {
    return std::sqrt(inflation.u[node_at(mesh, part, row * 101 + 50)]);
  };
  const double above = (height(1, 40) - height(0, 39)) / 2;
  const double below = (height(1, 41) - height(1, 40)) / 2;
  EXPECT_NEAR(above, below, 0.05);
  EXPECT_GT(height(1, 40), 20);
}

TEST(Inflate, NamesThePartThatNothingHolds) {
  LayeredMesh mesh =
      stack_parts(testing::grid_mesh(8, 4, 10),
                  {testing::in_box({0, 0}, {40, 40}), testing::in_box({40, 0}, {80, 40})});
  for (size_t n = 0; n < mesh.node_role.size(); ++n)
    if (mesh.node_part[n] == 1) mesh.node_role[n] = NodeRole::flap;
  const Result<Inflation> result = inflate(mesh, scene_of(mesh), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::bad_input);
  EXPECT_EQ(result.error().where, "part1");
  EXPECT_EQ(to_string(result.error().culprit), "parts[1]");
}

TEST(Inflate, RefusesOptionsOutOfRange) {
  const LayeredMesh mesh = disc(3);
  for (const InflationOptions& options :
       {InflationOptions{-0.1, 0.25}, InflationOptions{1.1, 0.25}, InflationOptions{0.1, 0},
        InflationOptions{std::nan(""), 0.25}, InflationOptions{0.1, INFINITY}}) {
    const Result<Inflation> result = inflate(mesh, scene_of(mesh), options);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::usage);
  }
}

TEST(Inflate, StopsWhenCancelled) {
  const std::atomic<bool> cancel = true;
  const LayeredMesh mesh = disc(3);
  const Result<Inflation> result = inflate(mesh, scene_of(mesh), {}, RunContext{&cancel, {}});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace relievo::relief
