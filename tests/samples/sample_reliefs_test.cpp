#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "samples/drawing_relief.h"
#include "support/mesh_checks.h"
#include "support/probe.h"
#include "support/seams.h"

namespace relievo {
namespace {

using namespace testing;

/// A character with the number of vertices of the paper's model of the same name [P Table 1].
struct Sample {
  const char* name;
  int vertices;
};

class SampleRelief : public ::testing::TestWithParam<Sample> {
 protected:
  static std::string path() {
    return std::string(RELIEVO_EXAMPLES) + "/" + GetParam().name + ".svg";
  }
  static relief::ReliefOptions options() {
    relief::ReliefOptions options;
    options.layers.vertex_budget = GetParam().vertices;
    return options;
  }
};

TEST_P(SampleRelief, IsManifoldAndMeetsTheBudget) {
  const DrawnRelief drawn = relief_of(path(), options());
  const relief::LayeredMesh& mesh = drawn.relief.layers;
  EXPECT_EQ(inconsistency(mesh), "");
  const Manifoldness m = check_manifold(mesh);
  EXPECT_EQ(m.repeated_edges, 0);
  EXPECT_EQ(m.bow_ties, 0);
  EXPECT_NEAR(static_cast<double>(mesh.node_vertex.size()), GetParam().vertices,
              0.05 * GetParam().vertices);
  EXPECT_TRUE(mesh.warnings.empty());
}

TEST_P(SampleRelief, IsOptimalAndInOrder) {
  const DrawnRelief drawn = relief_of(path(), options());
  const relief::Ordering& ordering = drawn.relief.ordering;
  EXPECT_EQ(ordering.report.status, SolveStatus::solved);
  EXPECT_LE(ordering.report.iterations, 6);
  EXPECT_LE(ordering.report.stationarity, 1e-12);
  EXPECT_EQ(ordering.report.primal, 0);
  EXPECT_LE(ordering.report.dual, 1e-12);
  EXPECT_LE(ordering.report.complementarity, 1e-12);
  EXPECT_EQ(ordering.max_violation, 0);
  EXPECT_LE(drawn.relief.ordering.overlap_worst, 1);  // px, of slivers whose nodes are all seen
}

TEST_P(SampleRelief, DoesNotDependOnTheFirstGuess) {
  relief::ReliefOptions all_active = options();
  all_active.ordering.start_active = true;
  const DrawnRelief a = relief_of(path(), options());
  const DrawnRelief b = relief_of(path(), all_active);
  ASSERT_EQ(a.relief.ordering.h.size(), b.relief.ordering.h.size());
  double worst = 0;
  for (size_t n = 0; n < a.relief.ordering.h.size(); ++n)
    worst = std::max(worst, std::abs(a.relief.ordering.h[n] - b.relief.ordering.h[n]));
  EXPECT_LE(worst, 1e-5);  // px
}

TEST_P(SampleRelief, HasNoEdgeAlongItsJoins) {
  for (const Method method : {Method::approximate, Method::nonlinear}) {
    relief::ReliefOptions with_method = options();
    with_method.method = method;
    const relief::Relief relief = relief_of(path(), with_method).relief;
    std::vector<double> medians;
    for (const SeamChain& chain : seam_chains(relief.layers)) {
      const std::vector<double> angles = seam_angles(relief.layers, relief.ordering.h, chain);
      if (angles.empty()) continue;
      EXPECT_LE(angles.back(), 2) << "part " << chain.upper;
      medians.push_back(angles[angles.size() / 2]);
    }
    ASSERT_FALSE(medians.empty());
    std::sort(medians.begin(), medians.end());
    EXPECT_LE(medians[medians.size() / 2], 1.2);
  }
}

/// The lowest ratio of the height at a join's end to the mean height on a circle around it, a
/// sixth of the join's chord in radius. A pit makes it small.
double deepest_pit(const DrawnRelief& drawn) {
  double lowest = 1;
  for (const Join& join : drawn.scene.joins) {
    const Point2 a = join.line.front();
    const Point2 b = join.line.back();
    for (const Point2 end : {a, b}) {
      const double radius = distance(a, b) / 6;
      double sum = 0;
      for (int i = 0; i < 16; ++i) {
        const double angle = 2 * M_PI * (i + 0.5) / 16;
        sum += probe(drawn.relief, end + radius * Point2{std::cos(angle), std::sin(angle)}).h();
      }
      lowest = std::min(lowest, 16 * probe(drawn.relief, end).h() / sum);
    }
  }
  return lowest;
}

TEST_P(SampleRelief, HasPitsWithDirichletEndsOnly) {
  relief::ReliefOptions pinned = options();
  pinned.inflation.alpha0 = 1;
  EXPECT_GE(deepest_pit(relief_of(path(), options())), 0.9);
  EXPECT_LE(deepest_pit(relief_of(path(), pinned)), 0.85);
}

INSTANTIATE_TEST_SUITE_P(PaperSizes, SampleRelief,
                         ::testing::Values(Sample{"wolf", 32000}, Sample{"bunny", 19000},
                                           Sample{"farmer", 33000}, Sample{"unicorn", 22000},
                                           Sample{"elephant", 39000}, Sample{"lamb", 30000}),
                         [](const auto& sample) { return std::string(sample.param.name); });

}  // namespace
}  // namespace relievo
