#include "research/rivals/graft.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "relief/discretisation/discretisation.h"
#include "research/tests/rival_case.h"
#include "seams/seam_chains.h"
#include "support/scenes.h"
#include "support/stacked_parts.h"

namespace relievo::research {
namespace {

using testing::Cover;

constexpr double disc_radius = 200;
const Cover everywhere = [](int, Point2) { return true; };

/// A disc around the origin, and the band |x| < 40 of it.
struct BandedDisc {
  explicit BandedDisc(int rings)
      : mesh(testing::stack_parts(testing::disc_mesh(disc_radius, rings), {everywhere})),
        discretisation(relief::discretise(mesh)) {
    for (size_t n = 0; n < mesh.node_vertex.size(); ++n) band.push_back(std::abs(at(n).x) < 40);
  }

  Point2 at(size_t n) const { return mesh.vertices[mesh.node_vertex[n]]; }

  template <class Function>
  std::vector<double> values(Function f) const {
    std::vector<double> h;
    for (size_t n = 0; n < mesh.node_vertex.size(); ++n) h.push_back(f(at(n)));
    return h;
  }

  relief::LayeredMesh mesh;
  relief::Discretisation discretisation;
  std::vector<uint8_t> band;
};

Graft grafted(const BandedDisc& disc, const std::vector<double>& h) {
  const auto result = graft(disc.mesh, disc.discretisation, h, disc.band);
  EXPECT_TRUE(result);
  return *result;
}

/// Far from the ends of the band, where the outline is.
bool is_middle(Point2 p) { return std::abs(p.y) < 100; }

TEST(Graft, SolvesItsEquationAndLeavesTheRest) {
  const BandedDisc disc(30);
  const std::vector<double> h =
      disc.values([](Point2 p) { return std::abs(p.x) + 0.001 * p.y * p.y; });
  const Graft result = grafted(disc, h);
  EXPECT_LE(result.residual, 1e-10);
  double moved = 0;
  for (size_t n = 0; n < h.size(); ++n) {
    if (disc.band[n] == 0) {
      ASSERT_EQ(result.h[n], h[n]);
    }
    moved = std::max(moved, std::abs(result.h[n] - h[n]));
  }
  EXPECT_GT(moved, 5);
}

TEST(Graft, KeepsPlanes) {
  const BandedDisc disc(20);
  const auto plane = disc.values([](Point2 p) { return 3 + 0.5 * p.x - 0.25 * p.y; });
  const Graft result = grafted(disc, plane);
  for (size_t n = 0; n < plane.size(); ++n) EXPECT_NEAR(result.h[n], plane[n], 1e-6);
}

/// Across a long band with |x| on both sides the solution is the cubic with that height and slope
/// at the edges.
TEST(Graft, ContinuesHeightAndSlopeButNotCurvature) {
  for (const int rings : {20, 40, 80}) {
    const BandedDisc disc(rings);
    const auto roof = disc.values([](Point2 p) { return std::abs(p.x); });
    const Graft result = grafted(disc, roof);
    const double edge = disc_radius / rings;
    const std::vector<Point2> slopes = node_gradients(disc.discretisation.gradients, result.h);
    for (size_t n = 0; n < roof.size(); ++n) {
      const Point2 p = disc.at(n);
      if (!is_middle(p)) continue;
      // |x| = a at the edge with slope 1: h = a / 2 + x^2 / (2 a).
      if (std::abs(p.x) < 40) {
        EXPECT_NEAR(result.h[n], 20 + p.x * p.x / 80, 0.5 * edge) << rings;
      }
      if (std::abs(std::abs(p.x) - 40) < edge) {
        EXPECT_NEAR(std::abs(slopes[n].x), 1, 0.08 * edge) << rings << " at " << p.x;
      }
    }
  }
}

TEST(Graft, BandIsAsWideAsItIsSaidAlongTheSurface) {
  const relief::LayeredMesh mesh = layered(testing::body_and_leg());
  const std::vector<uint8_t> band = band_around_joins(mesh, 0.25);
  const auto chains = testing::seam_chains(mesh);
  ASSERT_EQ(chains.size(), 1U);
  const double reach = 0.25 * chains[0].length.back();
  EXPECT_NEAR(reach, 10, 0.1);
  int within = 0;
  for (size_t n = 0; n < band.size(); ++n) {
    const Point2 p = mesh.vertices[mesh.node_vertex[n]];
    const Point2 nearest{std::clamp(p.x, 180.0, 220.0), 160};
    if (distance(p, nearest) > reach + mesh.edge_length) {
      EXPECT_EQ(band[n], 0);
    }
    const bool above = p.x > 182 && p.x < 218 && p.y < 159.5 && p.y > 160 - reach + 2;
    if (above && mesh.node_part[n] == 0) {
      EXPECT_EQ(band[n], 1) << p.x << " " << p.y;
      ++within;
    }
  }
  EXPECT_GT(within, 10);
}

TEST(Graft, OfNothingChangesNothing) {
  BandedDisc disc(10);
  std::fill(disc.band.begin(), disc.band.end(), 0);
  const auto h = disc.values([](Point2 p) { return p.x * p.x; });
  EXPECT_EQ(grafted(disc, h).h, h);
}

}  // namespace
}  // namespace relievo::research
