#include <gtest/gtest.h>

#include <cmath>

#include "support/augmented_lagrangian.h"
#include "support/ipopt_nonlinear.h"
#include "support/lbfgs.h"
#include "support/nonlinear_case.h"
#include "support/random_scene.h"

namespace relievo::relief {
namespace {

using namespace testing;
using Eigen::VectorXd;

/// Random numbers in [-1, 1].
VectorXd random_vector(Random& random, Eigen::Index size) {
  VectorXd v(size);
  for (double& x : v) x = random.uniform(-1, 1);
  return v;
}

TEST(NonlinearProgram, DerivativesAgreeWithDifferences) {
  const NonlinearCase test = nonlinear_case(leaning(body_and_leg(), 1), 600, 3);
  const Relief& relief = test.approximate;
  const NonlinearProgram program =
      make_nonlinear_program(relief.layers, test.scene, test.options.nonlinear, relief.inflation);
  Random random(1);
  NonlinearPoint at = point_of(program, relief.inflation, relief.ordering);
  at.p = (at.p.array() + 0.01).matrix();
  const NonlinearPoint slope = gradient(program, at);
  for (int trial = 0; trial < 20; ++trial) {
    const NonlinearPoint way{random_vector(random, at.p.size()),
                             random_vector(random, at.g.size())};
    const double step = 1e-4;
    const double ahead = energy(program, {at.p + step * way.p, at.g + step * way.g});
    const double behind = energy(program, {at.p - step * way.p, at.g - step * way.g});
    const double along = slope.p.dot(way.p) + slope.g.dot(way.g);
    EXPECT_NEAR((ahead - behind) / (2 * step), along, 1e-6 * slope.p.lpNorm<1>());
  }
}

TEST(NonlinearProgram, AgreesWithTheReportedEnergy) {
  Scene scene = body_and_leg();
  scene.parts[0].lean = {0.3, -0.1};
  scene.parts[1].flat = 0.3;
  const NonlinearCase test = nonlinear_case(scene, 1500, 1);
  const NonlinearSolution solution = solve(test);
  const NonlinearProgram program = make_nonlinear_program(
      test.approximate.layers, test.scene, test.options.nonlinear, solution.inflation);
  const NonlinearPoint point = point_of(program, solution.inflation, solution.ordering);
  EXPECT_NEAR(energy(program, point), solution.report.energy.total(),
              1e-10 * solution.report.energy.total());
  EXPECT_LE(violation(program, point), 1e-12);
}

/// The number of times that Ipopt converged and that it found a lower energy, and the worst ratio
/// of our energy to its own.
struct Comparison {
  int scenes = 0;
  int refused = 0;
  int converged = 0;
  int lower = 0;
  double worst = 0;
};

/// Finds scenes whose surfaces have one sign each, since others have several minima, and without
/// bumps, which are raised afterwards.
Comparison compare_with_ipopt(double lambda_bnd, int scenes, bool glue) {
  Comparison comparison;
  for (uint64_t seed = 1; comparison.scenes < scenes; ++seed) {
    const Scene scene = seed % 2 == 0 ? leaning(random_scene(seed), seed) : random_scene(seed);
    const auto relief = build_relief(scene, nonlinear_options(300, lambda_bnd));
    if (!relief && relief.error().code == ErrorCode::bad_input) {
      // Few scenes have joins that cross at their ends.
      if (++comparison.refused > scenes) return comparison;
      continue;
    }
    const NonlinearCase test = nonlinear_case(scene, 300, lambda_bnd, glue);
    const Relief& start = test.approximate;
    if (!start.layers.bump_nodes.empty()) continue;
    if (start.layers.ramp_nodes.empty() || !has_pure_surfaces(start.layers, test.scene)) continue;
    ++comparison.scenes;
    const NonlinearSolution ours = solve(test);
    EXPECT_EQ(ours.report.status, SolveStatus::solved) << seed;
    EXPECT_LE(ours.ordering.max_violation, 1e-9) << seed;
    const NonlinearProgram program =
        make_nonlinear_program(start.layers, test.scene, test.options.nonlinear, ours.inflation);
    const auto theirs =
        solve_joint_by_ipopt(program, point_of(program, start.inflation, start.ordering));
    if (!theirs || violation(program, *theirs) > 1e-7) continue;
    ++comparison.converged;
    const double ratio = ours.report.energy.total() / energy(program, *theirs);
    if (ratio > 1 + 1e-6) ++comparison.lower;
    comparison.worst = std::max(comparison.worst, ratio);
  }
  return comparison;
}

void expect_no_lower_energy(const Comparison& comparison, int at_least) {
  EXPECT_LE(comparison.refused, comparison.scenes / 5);
  EXPECT_GE(comparison.converged, at_least);
  EXPECT_EQ(comparison.lower, 0) << comparison.worst;
}

TEST(NonlinearReferences, IpoptFindsNothingBetterWithStiffBounds) {
  expect_no_lower_energy(compare_with_ipopt(100, 50, true), 40);
}

TEST(NonlinearReferences, IpoptFindsNothingBetterWithStiffBoundsThatAreNotGlued) {
  expect_no_lower_energy(compare_with_ipopt(100, 50, false), 40);
}

TEST(NonlinearReferences, IpoptFindsNothingBetterWithSoftBounds) {
  expect_no_lower_energy(compare_with_ipopt(0.01, 50, true), 30);
}

TEST(NonlinearReferences, DescentOnTheAugmentedLagrangianComesToTheSameEnergy) {
  const NonlinearCase test = nonlinear_case(body_and_leg(), 300, 100);
  const Relief& start = test.approximate;
  const NonlinearSolution ours = solve(test);
  const NonlinearProgram program =
      make_nonlinear_program(start.layers, test.scene, test.options.nonlinear, ours.inflation);
  VectorXd x = descent_start(program, point_of(program, start.inflation, start.ordering));
  AugmentedLagrangian lagrangian(program, 30);
  for (int outer = 0; outer < 25; ++outer) {
    x = minimise_by_lbfgs(lagrangian, x, 3000);
    lagrangian.update(x);
  }
  const NonlinearPoint end = lagrangian.point(x);
  EXPECT_LE(violation(program, end), 1e-5);
  const double e = ours.report.energy.total();
  EXPECT_NEAR(energy(program, end), e, 1e-3 * e);
  EXPECT_LE(e, (1 + 1e-4) * energy(program, end));
}

}  // namespace
}  // namespace relievo::relief
