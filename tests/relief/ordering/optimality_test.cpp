#include <gtest/gtest.h>

#include <cmath>

#include "kernel/operators/laplacian.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/order_depth.h"
#include "support/depth_optimality.h"
#include "support/enforced_pairs.h"
#include "support/ipopt_qp.h"
#include "support/random_depth.h"
#include "support/solve_once.h"

namespace relievo::relief {
namespace {

using testing::check_depth_optimality;
using testing::enforced_pairs;
using testing::RandomDepth;

Ordering ordered(const RandomDepth& random, const OrderingOptions& options) {
  const Result<Ordering> result = order_depth(random.mesh, random.inflation, random.scene, options);
  RC_ASSERT(result.ok());
  return *result;
}

void check_random_part_graph() {
  const RandomDepth random = testing::random_depth();
  const OrderingOptions options;
  const Ordering ordering = ordered(random, options);
  RC_ASSERT(ordering.max_violation == 0);
  RC_ASSERT(ordering.report.stationarity <= 1e-12);
  RC_ASSERT(ordering.report.primal == 0);
  RC_ASSERT(ordering.report.dual <= 1e-12);
  RC_ASSERT(ordering.report.complementarity == 0);
  const testing::DepthOptimality optimality =
      check_depth_optimality({random.mesh, random.scene, options.epsilon}, random.inflation,
                             enforced_pairs(random.mesh), ordering.h);
  RC_ASSERT(optimality.violation == 0);
  RC_ASSERT(optimality.imbalance <= 1e-12);
}

TEST(Optimality, HoldsOnAThousandRandomPartGraphs) {
  // RapidCheck runs a property a hundred times.
  EXPECT_TRUE(rc::check([] {
    for (int i = 0; i < 10; ++i) check_random_part_graph();
  }));
}

TEST(Optimality, TheCheckNoticesWrongHeights) {
  EXPECT_TRUE(rc::check([] {
    const RandomDepth random = testing::random_depth();
    const OrderingOptions options;
    Ordering ordering = ordered(random, options);
    ordering.h[*rc::gen::inRange<size_t>(0, ordering.h.size())] += *rc::gen::element(-1e-3, 1e-3);
    const testing::DepthOptimality optimality =
        check_depth_optimality({random.mesh, random.scene, options.epsilon}, random.inflation,
                               enforced_pairs(random.mesh), ordering.h);
    RC_ASSERT(optimality.violation > 1e-6 || optimality.imbalance > 1e-6);
  }));
}

TEST(Optimality, TheMinimiserDoesNotDependOnTheStart) {
  EXPECT_TRUE(rc::check([] {
    const RandomDepth random = testing::random_depth();
    OrderingOptions options;
    const Ordering none = ordered(random, options);
    options.start_active = true;
    const Ordering all = ordered(random, options);
    for (size_t n = 0; n < none.h.size(); ++n) RC_ASSERT(std::abs(none.h[n] - all.h[n]) <= 1e-9);
  }));
}

testing::LinearlyConstrainedQp stated_directly(const RandomDepth& random, double epsilon) {
  const double scale = scene_scale(random.mesh);
  const std::vector<Point2> positions = node_positions(random.mesh, scale);
  const FlatMesh flat{positions, random.mesh.faces};
  testing::LinearlyConstrainedQp qp;
  SparseMatrix A = stiffness_matrix(flat);
  A.diagonal() += epsilon * lumped_mass(flat);
  qp.H = A;
  Eigen::VectorXd f(A.rows());
  for (Eigen::Index n = 0; n < f.size(); ++n) {
    const double u = random.inflation.u[n];
    f[n] = scale * std::copysign(std::sqrt(std::abs(u)), u);
  }
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(f.size());
  qp.b = A * f - testing::ShiftCost{random.mesh, random.scene, epsilon}.slope(still);
  const std::vector<DepthPair> pairs = enforced_pairs(random.mesh);
  const int rows = static_cast<int>(pairs.size());
  qp.C.resize(rows, A.rows());
  qp.lower = Eigen::VectorXd::Zero(rows);
  qp.upper = Eigen::VectorXd::Constant(rows, testing::unlimited);
  for (int i = 0; i < rows; ++i) {
    qp.C.insert(i, pairs[i].upper) = 1;
    qp.C.insert(i, pairs[i].lower) = -1;
    if (pairs[i].equal) qp.upper[i] = 0;
  }
  return qp;
}

TEST(Optimality, IpoptFindsTheSameHeights) {
  EXPECT_TRUE(rc::check([] {
    const RandomDepth random = testing::random_depth();
    OrderingOptions options;
    // An interior point method finds heights that only a tiny epsilon determines inexactly.
    options.epsilon = 0.1;
    const Ordering ordering = ordered(random, options);
    const auto h = testing::solve_by_ipopt(stated_directly(random, options.epsilon));
    RC_ASSERT(h.has_value());
    const double scale = scene_scale(random.mesh);
    for (Eigen::Index n = 0; n < h->size(); ++n)
      RC_ASSERT(std::abs((*h)[n] - scale * ordering.h[n]) <= 1e-4);
  }));
}

}  // namespace
}  // namespace relievo::relief
