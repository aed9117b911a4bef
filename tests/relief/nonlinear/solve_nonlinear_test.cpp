#include "relief/nonlinear/solve_nonlinear.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflate.h"
#include "support/depth_optimality.h"
#include "support/enforced_pairs.h"
#include "support/nonlinear_case.h"
#include "support/probe.h"
#include "support/random_scene.h"
#include "support/solve_once.h"

namespace relievo::relief {
namespace {

using namespace testing;
using Eigen::VectorXd;

/// Returns the largest residual of the balance between the forces of the depth pairs on f and the
/// slope of the inflation energy, at free nodes and on B, relative to the largest force.
double imbalance_of_inflation(const NonlinearProgram& program, const NonlinearPoint& at) {
  const NonlinearPoint slope = gradient(program, at);
  const VectorXd root = VectorXd::NullaryExpr(at.p.size(), [&](Eigen::Index i) {
    return at.p[i] > 0 ? root_slope(program, at, static_cast<int>(i)) : 0;
  });
  double worst = 0;
  double largest = 0;
  for (int i = 0; i < at.p.size(); ++i) {
    const double force = slope.g[program.node[i]];
    if (on_bound(program, i) && at.p[i] == 0) {
      worst = std::max(worst, force * program.sign[program.node[i]]);
      continue;
    }
    const double work = force * root[i];
    worst = std::max(worst, std::abs(slope.p[i] - work));
    largest = std::max({largest, std::abs(slope.p[i]), std::abs(work)});
  }
  return worst / std::max(largest, 1e-3);
}

class RandomScenes : public ::testing::TestWithParam<double> {};

TEST_P(RandomScenes, EndAtPointsWhereAllForcesBalance) {
  int pure = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    NonlinearCase test = nonlinear_case(leaning(random_scene(seed), seed), 2000, GetParam());
    test.options.nonlinear.tolerance = 1e-7;
    const LayeredMesh& mesh = test.approximate.layers;
    const NonlinearSolution solution = solve(test);
    EXPECT_EQ(solution.report.status, SolveStatus::solved) << seed;
    EXPECT_LE(solution.ordering.max_violation, 1e-9) << seed;
    EXPECT_LE(solution.ordering.report.stationarity, 1e-11) << seed;
    const DepthOptimality order =
        check_depth_optimality({mesh, test.scene, test.options.nonlinear.ordering.epsilon},
                               solution.inflation, enforced_pairs(mesh), solution.ordering.h);
    EXPECT_LE(order.imbalance, 1e-10) << seed;
    if (!has_pure_surfaces(mesh, test.scene)) continue;
    ++pure;
    const NonlinearProgram program =
        make_nonlinear_program(mesh, test.scene, test.options.nonlinear, solution.inflation);
    const NonlinearPoint at = point_of(program, solution.inflation, solution.ordering);
    EXPECT_LE(imbalance_of_inflation(program, at), 1e-4) << seed;
  }
  EXPECT_GE(pure, 20);
}

TEST_P(RandomScenes, OfTwoThousandNodesConverge) {
  for (uint64_t seed = 41; seed <= 140; ++seed) {
    ReliefOptions options;
    options.method = Method::nonlinear;
    options.layers.vertex_budget = 2000;
    options.nonlinear.lambda_bnd = GetParam();
    const Result<Relief> relief = build_relief(random_scene(seed), options);
    ASSERT_TRUE(relief.ok()) << seed << to_string(relief.error());
    EXPECT_EQ(relief->nonlinear.status, SolveStatus::solved) << seed;
    EXPECT_LE(relief->nonlinear.residual, options.nonlinear.tolerance) << seed;
    EXPECT_LE(relief->ordering.max_violation, 1e-9) << seed;
  }
}

// Surfaces of these scenes join parts with d > 0 and d < 0 that touch others where u passes 0.
TEST_P(RandomScenes, OfBothSignsConvergeOnFineMeshes) {
  for (const uint64_t seed : {7, 12, 21, 150, 195}) {
    ReliefOptions options;
    options.method = Method::nonlinear;
    options.layers.vertex_budget = 12000;
    options.nonlinear.lambda_bnd = GetParam();
    const Result<Relief> relief = build_relief(random_scene(seed), options);
    ASSERT_TRUE(relief.ok()) << seed << to_string(relief.error());
    EXPECT_EQ(relief->nonlinear.status, SolveStatus::solved) << seed;
    EXPECT_LE(relief->ordering.max_violation, 1e-9) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Lambda, RandomScenes, ::testing::Values(100.0, 0.01));

Scene scaled(Scene scene, double factor) {
  scene.width *= factor;
  scene.height *= factor;
  for (Part& part : scene.parts)
    for (Ring& ring : part.outline)
      for (Point2& p : ring) p = factor * p;
  for (Join& join : scene.joins)
    for (Point2& p : join.line) p = factor * p;
  return scene;
}

TEST(SolveNonlinear, DoesNotDependOnTheUnitOfLength) {
  // A power of two scales all numbers exactly.
  const NonlinearSolution small = solve(nonlinear_case(body_and_leg(), 2000, 1));
  const NonlinearSolution large = solve(nonlinear_case(scaled(body_and_leg(), 4), 2000, 1));
  EXPECT_EQ(small.report.energy.total(), large.report.energy.total());
  ASSERT_EQ(small.ordering.h.size(), large.ordering.h.size());
  for (size_t n = 0; n < small.ordering.h.size(); ++n)
    EXPECT_EQ(4 * small.ordering.h[n], large.ordering.h[n]);
}

TEST(SolveNonlinear, HardlyDependsOnTheMesh) {
  const double coarse = solve(nonlinear_case(body_and_leg(), 2500, 100)).report.energy.total();
  const double fine = solve(nonlinear_case(body_and_leg(), 10000, 100)).report.energy.total();
  EXPECT_NEAR(coarse, fine, 0.02 * fine);
}

TEST(SolveNonlinear, GivesTheSameBitsAgain) {
  const NonlinearCase test = nonlinear_case(random_scene(5), 2000, 0.01);
  const NonlinearSolution a = solve(test);
  const NonlinearSolution b = solve(test);
  EXPECT_EQ(a.inflation.u, b.inflation.u);
  EXPECT_EQ(a.ordering.h, b.ordering.h);
}

TEST(SolveNonlinear, IsThePoissonInflationWhereNothingPresses) {
  Scene scene = canvas();
  scene.parts = {part("disc", circle({200, 200}, 100))};
  const NonlinearCase test = nonlinear_case(scene, 2000, 1);
  const NonlinearSolution solution = solve(test);
  EXPECT_NEAR(solution.report.energy.total(), 0, 1e-20);
  for (size_t n = 0; n < solution.inflation.u.size(); ++n) {
    EXPECT_NEAR(solution.inflation.u[n], test.approximate.inflation.u[n], 1e-7);
    EXPECT_EQ(solution.ordering.g[n], 0);
  }
}

TEST(SolveNonlinear, DoesNotDependOnTheStart) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 100);
  const NonlinearSolution usual = solve(test);
  for (double& u : test.approximate.inflation.u) u = 0.25 * u + 100;
  const NonlinearSolution other = solve(test);
  EXPECT_NEAR(other.report.energy.total(), usual.report.energy.total(),
              1e-9 * usual.report.energy.total());
}

Result<NonlinearSolution> solve_from(const NonlinearMemory& known, const NonlinearCase& test) {
  const Relief& start = test.approximate;
  const Discretisation discretisation = discretise(start.layers);
  OrderingSystem system;
  return solve_nonlinear({start.layers, discretisation, test.scene}, start.inflation,
                         test.options.nonlinear, known, system);
}

TEST(SolveNonlinear, HasTheSameBitsWhereTheOrderWasPrepared) {
  const NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 0.01);
  const Relief& start = test.approximate;
  const Discretisation discretisation = discretise(start.layers);
  OrderingSystem system;
  prepare_ordering({start.layers, discretisation, test.scene}, {}, system);
  const auto prepared = solve_nonlinear({start.layers, discretisation, test.scene}, start.inflation,
                                        test.options.nonlinear, {}, system);
  ASSERT_TRUE(prepared.ok());
  const NonlinearSolution solution = solve(test);
  EXPECT_EQ(prepared->inflation.u, solution.inflation.u);
  EXPECT_EQ(prepared->ordering.h, solution.ordering.h);
}

TEST(SolveNonlinear, GoesOnWithTheSystemOfAnotherInflation) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 0.01);
  test.options.nonlinear.tolerance = 1e-6;
  const LayeredMesh& mesh = test.approximate.layers;
  const Discretisation discretisation = discretise(mesh);
  OrderingSystem system;
  NonlinearMemory known;
  for (const double c : {2.0, 3.0, 1.0}) {
    test.scene.parts[1].c = c;
    const Inflation start = *inflate(mesh, test.scene, {});
    const auto warm = solve_nonlinear({mesh, discretisation, test.scene}, start,
                                      test.options.nonlinear, known, system);
    const auto cold = solve_nonlinear(mesh, test.scene, start, test.options.nonlinear);
    ASSERT_TRUE(warm.ok() && cold.ok());
    EXPECT_LE(warm->ordering.report.stationarity, 1e-11);
    EXPECT_NEAR(warm->report.energy.total(), cold->report.energy.total(),
                1e-9 * cold->report.energy.total());
    known = warm->memory;
  }
}

TEST(SolveNonlinear, TakesFewerStepsFromWhatACoarseMeshKnows) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 8000, 0.01);
  test.options.nonlinear.tolerance = 1e-6;
  const auto known = solve_from(solve(nonlinear_case(body_and_leg(), 1000, 0.01)).memory, test);
  const NonlinearSolution unaided = solve(test);
  ASSERT_TRUE(known.ok());
  EXPECT_LT(known->report.steps.size(), unaided.report.steps.size());
  EXPECT_NEAR(known->report.energy.total(), unaided.report.energy.total(),
              1e-9 * unaided.report.energy.total());
}

TEST(SolveNonlinear, EndsWhereFurtherStepsCannotBeSeen) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 8000, 0.01);
  const NonlinearSolution usual = solve(test);
  test.options.nonlinear.tolerance = 1e-9;
  const NonlinearSolution further = solve(test);
  EXPECT_GT(further.report.steps.size(), usual.report.steps.size());
  EXPECT_NEAR(usual.report.energy.total(), further.report.energy.total(),
              1e-7 * further.report.energy.total());
  for (size_t n = 0; n < usual.ordering.h.size(); ++n)
    ASSERT_NEAR(usual.ordering.h[n], further.ordering.h[n], 0.02);  // px
}

TEST(SolveNonlinear, RecordsEveryStep) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 100);
  test.options.nonlinear.tolerance = 1e-6;  // the energy of the last step is one of two halves
  const NonlinearSolution solution = solve(test);
  const std::vector<NonlinearStep>& steps = solution.report.steps;
  ASSERT_GE(steps.size(), 3u);
  EXPECT_GT(steps.front().residual, steps.back().residual);
  EXPECT_EQ(steps.back().residual, solution.report.residual);
  EXPECT_GE(steps.front().factorisations, 1);
  EXPECT_EQ(steps.back().factorisations, 1);
  EXPECT_NEAR(steps.back().energy.total(), solution.report.energy.total(),
              1e-6 * solution.report.energy.total());
}

TEST(SolveNonlinear, KeepsSurfacesOnTheWay) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 1);
  const int steps = static_cast<int>(solve(test).report.steps.size());
  test.options.nonlinear.snapshots = {1, 3, steps, 1000};
  const NonlinearSolution solution = solve(test);
  ASSERT_EQ(solution.snapshots.size(), 3u);
  const auto distance = [&](const NonlinearSnapshot& snapshot) {
    double worst = 0;
    for (size_t n = 0; n < solution.ordering.h.size(); ++n)
      worst = std::max(worst, std::abs(snapshot.ordering.h[n] - solution.ordering.h[n]));
    return worst;
  };
  for (const NonlinearSnapshot& snapshot : solution.snapshots)
    for (const DepthPair& pair : test.approximate.layers.constraints)
      EXPECT_LE(snapshot.ordering.h[pair.lower], snapshot.ordering.h[pair.upper] + 1e-9);
  EXPECT_GT(distance(solution.snapshots[0]), distance(solution.snapshots[1]));
  EXPECT_LT(distance(solution.snapshots[2]), 1e-6);
}

TEST(SolveNonlinear, TellsWhenItRunsOutOfSteps) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 1000, 100);
  test.options.nonlinear.max_iterations = 2;
  const NonlinearSolution solution = solve(test);
  EXPECT_EQ(solution.report.status, SolveStatus::iteration_limit);
  EXPECT_LE(solution.ordering.max_violation, 1e-9);
}

// For exact minima of a sum of two costs, a larger weight of one makes it smaller and the other one
// larger.
TEST(SolveNonlinear, DearerShiftsAreSmaller) {
  NonlinearCase test = nonlinear_case(body_and_leg(), 2000, 1);
  const Relief& start = test.approximate;
  double last_shift = 1e300;
  double last_rest = 0;
  for (const double lambda : {1e-2, 0.1, 1.0, 10.0, 100.0}) {
    test.options.nonlinear.lambda_shift = lambda;
    const auto solution =
        solve_nonlinear(start.layers, test.scene, start.inflation, test.options.nonlinear);
    ASSERT_TRUE(solution.ok()) << to_string(solution.error());
    EXPECT_EQ(solution->report.status, SolveStatus::solved) << lambda;
    const NonlinearEnergy& energy = solution->report.energy;
    const double shift = energy.shift / lambda;
    const double rest = energy.inflation + energy.boundary;
    EXPECT_LT(shift, last_shift) << lambda;
    EXPECT_GT(rest, last_rest) << lambda;
    last_shift = shift;
    last_rest = rest;
  }
}

TEST(SolveNonlinear, ReportsProgressAndStopsWhenAsked) {
  const NonlinearCase test = nonlinear_case(body_and_leg(), 1000, 100);
  std::atomic<bool> cancel = false;
  int calls = 0;
  RunContext context;
  context.cancel = &cancel;
  context.progress = [&](const char* stage, double fraction) {
    EXPECT_EQ(std::string(stage), "nonlinear");
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    cancel = ++calls == 2;
  };
  const Relief& start = test.approximate;
  const auto solution =
      solve_nonlinear(start.layers, test.scene, start.inflation, test.options.nonlinear, context);
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.error().code, ErrorCode::interrupted);
  EXPECT_EQ(calls, 2);
}

TEST(SolveNonlinear, RefusesOptionsThatMakeNoSense) {
  const NonlinearCase test = nonlinear_case(body_and_leg(), 300, 100);
  const Relief& start = test.approximate;
  const auto where = [&](auto change) {
    NonlinearOptions options = test.options.nonlinear;
    change(options);
    const auto solution = solve_nonlinear(start.layers, test.scene, start.inflation, options);
    return solution.ok() ? "accepted" : solution.error().where;
  };
  EXPECT_EQ(where([](NonlinearOptions& o) { o.lambda_bnd = 0; }), "lambda_bnd");
  for (const double shift : {-1.0, 0.0, 1e4, std::nan("")})
    EXPECT_EQ(where([=](NonlinearOptions& o) { o.lambda_shift = shift; }), "lambda_shift");
  EXPECT_EQ(where([](NonlinearOptions& o) { o.tolerance = std::nan(""); }), "tolerance");
  EXPECT_EQ(where([](NonlinearOptions& o) { o.max_iterations = 0; }), "max_iterations");
  EXPECT_EQ(where([](NonlinearOptions& o) { o.ordering.epsilon = 0; }), "epsilon");
  EXPECT_EQ(where([](NonlinearOptions& o) { o.snapshots = {3, 1}; }), "snapshots");
}

}  // namespace
}  // namespace relievo::relief
