#include "kernel/solvers/active_set.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>

#include "support/ipopt_qp.h"

namespace relievo {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Makes a dense problem of small integers, which make ties and degenerate bounds likely.
BoundQp random_problem(int n) {
  const auto entry = rc::gen::inRange(-3, 4);
  MatrixXd F(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) F(i, j) = *entry;
  const MatrixXd K = F * F.transpose() + MatrixXd::Identity(n, n);
  BoundQp problem;
  problem.K = MatrixXd(K.triangularView<Eigen::Lower>()).sparseView(0, -1);
  problem.b.resize(n);
  for (int i = 0; i < n; ++i) {
    problem.b[i] = *entry;
    const int kind = *rc::gen::inRange(0, 9);
    problem.bounded.push_back(kind > 2);
    problem.fixed.push_back(kind == 0);
  }
  return problem;
}

MatrixXd dense_K(const BoundQp& problem) {
  return MatrixXd(problem.K).selfadjointView<Eigen::Lower>();
}

/// Returns the best feasible point over all active sets.
VectorXd enumerate_active_sets(const BoundQp& problem) {
  const int n = static_cast<int>(problem.b.size());
  const auto is_fixed = [&](int i) { return !problem.fixed.empty() && problem.fixed[i] != 0; };
  VectorXd best = VectorXd::Zero(n);
  double lowest = 0;
  for (uint32_t set = 0; set < 1u << n; ++set) {
    MatrixXd K = dense_K(problem);
    VectorXd b = problem.b;
    bool allowed = true;
    for (int i = 0; i < n; ++i) {
      if ((set >> i & 1u) == 0) {
        allowed = allowed && !is_fixed(i);
        continue;
      }
      allowed = allowed && (problem.bounded[i] != 0 || is_fixed(i));
      K.row(i).setZero();
      K.col(i).setZero();
      K(i, i) = 1;
      b[i] = 0;
    }
    if (!allowed) continue;
    const VectorXd z = K.ldlt().solve(b);
    for (int i = 0; i < n; ++i) allowed = allowed && (problem.bounded[i] == 0 || z[i] >= -1e-12);
    const double energy = 0.5 * z.dot(dense_K(problem) * z) - problem.b.dot(z);
    if (allowed && energy < lowest) {
      lowest = energy;
      best = z;
    }
  }
  return best;
}

BoundQpSolution solve(const BoundQp& problem, const BoundQpOptions& options = {}) {
  SparseCholesky factor;
  factor.analyse(problem.K, Refactorisation::incremental);
  return solve_bound_qp(problem, factor, options);
}

TEST(BoundQp, AgreesWithEnumerationOfActiveSets) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 11));
    const BoundQpSolution solution = solve(problem);
    RC_ASSERT(solution.report.status == SolveStatus::solved);
    const VectorXd expected = enumerate_active_sets(problem);
    RC_ASSERT((solution.z - expected).lpNorm<Eigen::Infinity>() <= 1e-9);
  }));
}

TEST(BoundQp, SatisfiesTheOptimalityConditionsExactly) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 60));
    const BoundQpSolution solution = solve(problem);
    const VectorXd residual = dense_K(problem) * solution.z - problem.b - solution.mu;
    const double scale = std::max(1.0, problem.b.lpNorm<Eigen::Infinity>());
    RC_ASSERT(residual.lpNorm<Eigen::Infinity>() <= 1e-12 * scale);
    RC_ASSERT(solution.report.stationarity <= 1e-12);
    RC_ASSERT(solution.report.primal == 0);
    RC_ASSERT(solution.report.dual <= 1e-12);
    RC_ASSERT(solution.report.complementarity == 0);
    for (Eigen::Index i = 0; i < problem.b.size(); ++i) {
      RC_ASSERT(problem.bounded[i] == 0 || solution.z[i] >= 0);
      const bool at_bound = problem.bounded[i] != 0 && solution.z[i] == 0;
      RC_ASSERT((solution.active[i] != 0) == (at_bound || problem.fixed[i] != 0));
      RC_ASSERT(problem.fixed[i] == 0 || solution.z[i] == 0);
      RC_ASSERT(solution.mu[i] == 0 || solution.active[i] != 0);
    }
  }));
}

TEST(BoundQp, FindsTheSameMinimiserFromAnyStart) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 40));
    const VectorXd z = solve(problem).z;
    BoundQpOptions options;
    options.start_active = problem.bounded;
    RC_ASSERT((solve(problem, options).z - z).lpNorm<Eigen::Infinity>() <= 1e-10);
    for (auto& active : options.start_active) active = *rc::gen::inRange<uint8_t>(0, 2);
    RC_ASSERT((solve(problem, options).z - z).lpNorm<Eigen::Infinity>() <= 1e-10);
  }));
}

TEST(BoundQp, GoesOnFromAnyPointWithItsGradient) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 40));
    const BoundQpSolution cold = solve(problem);
    BoundQpOptions options;
    options.start = cold.z;
    for (Eigen::Index i = 0; i < options.start.size(); ++i)
      if (problem.fixed[i] == 0) options.start[i] += *rc::gen::inRange(-2, 3);
    options.start_gradient = dense_K(problem) * options.start - problem.b;
    options.refine = *rc::gen::arbitrary<bool>();
    const BoundQpSolution solution = solve(problem, options);
    const VectorXd gradient = dense_K(problem) * solution.z - problem.b;
    RC_ASSERT((solution.z - cold.z).lpNorm<Eigen::Infinity>() <= 1e-9);
    RC_ASSERT((solution.gradient - gradient).lpNorm<Eigen::Infinity>() <= 1e-9);
    RC_ASSERT((solution.mu - cold.mu).lpNorm<Eigen::Infinity>() <= 1e-9);
  }));
}

TEST(BoundQp, NeedsOneFactorisationFromTheRightStart) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 40));
    const BoundQpSolution cold = solve(problem);
    BoundQpOptions options;
    options.start_active = cold.active;
    const BoundQpSolution warm = solve(problem, options);
    RC_ASSERT(warm.report.factorisations == 1);
    RC_ASSERT((warm.z - cold.z).lpNorm<Eigen::Infinity>() <= 1e-12);
  }));
}

/// Makes the problem of a membrane of n x n nodes above 0 that is pulled up in the middle and
/// pressed down around it. It touches 0 in the corners.
BoundQp membrane(int n) {
  BoundQp problem;
  problem.K.resize(n * n, n * n);
  problem.b.resize(n * n);
  problem.bounded.assign(static_cast<size_t>(n) * n, 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n; ++i) {
    const double x = (i % n + 0.5) / n - 0.5;
    const double y = (i / n + 0.5) / n - 0.5;  // NOLINT(bugprone-integer-division)
    problem.b[i] = (std::hypot(x, y) < 0.2 ? 8.0 : -1.0) / (n * n);
    entries.emplace_back(i, i, 4);
    if (i % n > 0) entries.emplace_back(i, i - 1, -1);
    if (i >= n) entries.emplace_back(i, i - n, -1);
  }
  for (Eigen::Triplet<double>& e : entries)
    e = {std::max(e.row(), e.col()), std::min(e.row(), e.col()), e.value()};
  problem.K.setFromTriplets(entries.begin(), entries.end());
  return problem;
}

TEST(BoundQp, TakesFewStepsToTheBorderOfAContact) {
  for (const int n : {50, 100, 200}) {
    const BoundQp problem = membrane(n);
    SparseCholesky factor;
    factor.analyse(problem.K, Refactorisation::incremental);
    const BoundQpSolution solution = solve_bound_qp(problem, factor);
    EXPECT_EQ(solution.report.status, SolveStatus::solved);
    EXPECT_GT(solution.report.active, n * n / 20);
    EXPECT_LE(solution.report.iterations, 6) << n;
    EXPECT_EQ(solution.report.safeguard_steps, 0) << n;
  }
}

/// Makes the problem of a stiff string on a soft bed that lifts it to 1: in its first half above a
/// floor at 0, in its second half below a ceiling that is lowest, 0.2, over one of its nodes. The
/// unknowns are its distances from these.
BoundQp string_between(int n, int lowest, double bed) {
  VectorXd side(n);
  VectorXd limit(n);
  MatrixXd K = MatrixXd::Identity(n, n) * bed;
  for (int i = 0; i < n; ++i) {
    side[i] = i < n / 2 ? 1 : -1;
    limit[i] = i < n / 2 ? 0 : 0.2 + 0.002 * std::abs(i - lowest);
    if (i + 1 == n) continue;
    K(i, i) += 1;
    K(i + 1, i + 1) += 1;
    K(i, i + 1) = K(i + 1, i) = -1;
  }
  BoundQp problem;
  problem.b = side.asDiagonal() * K * (VectorXd::Ones(n) - limit);
  const MatrixXd K_signed = side.asDiagonal() * K * side.asDiagonal();
  problem.K = MatrixXd(K_signed.triangularView<Eigen::Lower>()).sparseView();
  problem.bounded.assign(static_cast<size_t>(n), 1);
  return problem;
}

TEST(BoundQp, CatchesWhatComesLooseAtItsLastBound) {
  const int n = 400;
  const int lowest = 310;
  BoundQpOptions options;
  options.start_active.assign(n, 0);
  options.start_active[0] = 1;
  const BoundQpSolution solution = solve(string_between(n, lowest, 1e-8), options);
  EXPECT_EQ(solution.report.status, SolveStatus::solved);
  EXPECT_EQ(solution.report.iterations, 3);
  EXPECT_EQ(solution.report.active, 1);
  EXPECT_EQ(solution.active[lowest], 1);
}

TEST(BoundQp, EndsAtTheSameBitsWhereverItBegins) {
  BoundQp problem = membrane(60);
  SparseCholesky factor;
  factor.analyse(problem.K, Refactorisation::incremental);
  const BoundQpSolution cold = solve_bound_qp(problem, factor);
  EXPECT_GT(cold.report.iterations, 2);
  BoundQpOptions options;
  for (const int left_out : {0, 1, 40}) {
    options.start_active = cold.active;
    for (int left = left_out, i = 0; left > 0; ++i)
      if (cold.active[i] != 0) {
        options.start_active[i] = 0;
        --left;
      }
    const BoundQpSolution warm = solve_bound_qp(problem, factor, options);
    EXPECT_EQ(warm.report.iterations == 1, left_out == 0);
    EXPECT_EQ(warm.active, cold.active);
    EXPECT_EQ(warm.z, cold.z);
  }
  problem.b *= 0.7;
  EXPECT_EQ(solve_bound_qp(problem, factor, options).z, solve(problem).z);
}

TEST(BoundQp, AgreesWithIpopt) {
  EXPECT_TRUE(rc::check([] {
    const BoundQp problem = random_problem(*rc::gen::inRange(1, 30));
    const int n = static_cast<int>(problem.b.size());
    testing::LinearlyConstrainedQp qp;
    qp.H = dense_K(problem).sparseView();
    qp.b = problem.b;
    qp.C.resize(n, n);
    qp.C.setIdentity();
    qp.lower = VectorXd::Constant(n, -testing::unlimited);
    for (int i = 0; i < n; ++i)
      if (problem.bounded[i] != 0) qp.lower[i] = 0;
    qp.upper = VectorXd::Constant(n, testing::unlimited);
    for (int i = 0; i < n; ++i)
      if (problem.fixed[i] != 0) qp.lower[i] = qp.upper[i] = 0;
    const auto expected = testing::solve_by_ipopt(qp);
    RC_ASSERT(expected.has_value());
    RC_ASSERT((solve(problem).z - *expected).lpNorm<Eigen::Infinity>() <= 1e-5);
  }));
}

TEST(BoundQp, EndsWhereBlockPivotingCycles) {
  // In many of these ill-conditioned problems flipping all wrong bounds cycles, and local
  // relaxation does not help.
  int safeguarded = 0;
  for (int seed = 0; seed < 100; ++seed) {
    const int n = 15 + seed % 45;
    uint32_t state = 77u + static_cast<uint32_t>(seed);
    const auto next = [&state] {
      state = state * 1664525u + 1013904223u;
      return static_cast<int>(state >> 16) % 9 - 4;
    };
    const int rank = n / 2;
    MatrixXd F(n, rank);
    for (int i = 0; i < n * rank; ++i) F(i / rank, i % rank) = next();
    BoundQp problem;
    const MatrixXd K = F * F.transpose() + 1e-3 * MatrixXd::Identity(n, n);
    problem.K = MatrixXd(K.triangularView<Eigen::Lower>()).sparseView(0, -1);
    problem.b.resize(n);
    for (int i = 0; i < n; ++i) problem.b[i] = next();
    problem.bounded.assign(static_cast<size_t>(n), 1);
    const BoundQpSolution solution = solve(problem);
    ASSERT_EQ(solution.report.status, SolveStatus::solved);
    const VectorXd gradient = K * solution.z - problem.b;
    ASSERT_GE(solution.z.minCoeff(), 0);
    ASSERT_GE(gradient.minCoeff(), -1e-9);
    ASSERT_LE(gradient.cwiseProduct(solution.z).lpNorm<Eigen::Infinity>(),
              1e-9 * std::max(1.0, solution.z.maxCoeff()));
    safeguarded += solution.report.safeguard_steps > 0;
  }
  EXPECT_GT(safeguarded, 10);
}

BoundQp small_problem() {
  BoundQp problem;
  problem.K.resize(2, 2);
  problem.K.insert(0, 0) = 2;
  problem.K.insert(1, 0) = -1;
  problem.K.insert(1, 1) = 2;
  problem.K.makeCompressed();
  problem.b = Eigen::Vector2d(1, -3);
  problem.bounded = {1, 1};
  return problem;
}

TEST(BoundQp, ReportsTheEnergyAndTheActiveBounds) {
  const BoundQpSolution solution = solve(small_problem());
  EXPECT_DOUBLE_EQ(solution.z[0], 0.5);
  EXPECT_EQ(solution.z[1], 0);
  EXPECT_EQ(solution.mu[0], 0);
  EXPECT_DOUBLE_EQ(solution.mu[1], 2.5);
  EXPECT_EQ(solution.report.active, 1);
  EXPECT_DOUBLE_EQ(solution.report.energy, -0.25);
}

TEST(BoundQp, StopsWhenCancelled) {
  std::atomic<bool> cancel = true;
  const BoundQp problem = small_problem();
  SparseCholesky factor;
  factor.analyse(problem.K, Refactorisation::incremental);
  const BoundQpSolution solution = solve_bound_qp(problem, factor, {}, RunContext{&cancel, {}});
  EXPECT_EQ(solution.report.status, SolveStatus::interrupted);
  EXPECT_EQ(solution.report.factorisations, 0);
}

TEST(BoundQp, StopsAtTheIterationLimit) {
  BoundQpOptions options;
  options.max_iterations = 1;
  EXPECT_EQ(solve(small_problem(), options).report.status, SolveStatus::iteration_limit);
}

TEST(BoundQp, RefusesAnIndefiniteMatrix) {
  BoundQp problem = small_problem();
  problem.K.coeffRef(1, 1) = -2;
  EXPECT_EQ(solve(problem).report.status, SolveStatus::not_positive_definite);
}

}  // namespace
}  // namespace relievo
