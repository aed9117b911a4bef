#include "relief/joint/bound_step.h"

#include <algorithm>
#include <numeric>

#include "kernel/solvers/symmetric_graph.h"
#include "relief/inflation/poisson_terms.h"
#include "relief/joint/soft_matrix.h"

namespace relievo {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The matrix serves as long as no spring has changed by so much of the stiffness there.
constexpr double tolerated_change = 0.1;

/// It only leads the way.
constexpr double step_tolerance = 1e-9;

/// Heights farther from B than so many edges, but at least one for so many nodes of B, are held:
/// that stiffens long waves a little, and waves die away over their length.
constexpr int nearest_rings = 8;
constexpr int nodes_per_ring = 20;

/// The unknowns that move with B. Those that are held have place -1, the others one that rises
/// with their number.
struct Surroundings {
  std::vector<int> place;
  int size = 0;
};

Surroundings surroundings(const SoftMatrix& matrix) {
  const SymmetricGraph graph = make_symmetric_graph(matrix.K);
  const auto heights = static_cast<int>(matrix.heights());
  std::vector<int> near(matrix.own_stiffness.size());
  std::iota(near.begin(), near.end(), heights);
  Surroundings result{std::vector<int>(static_cast<size_t>(graph.size()), -1), 0};
  for (const int i : near) result.place[i] = 0;
  const int rings = std::max(nearest_rings, static_cast<int>(near.size()) / nodes_per_ring);
  size_t first = 0;
  for (int ring = 0; ring < rings; ++ring)
    for (const size_t last = near.size(); first < last; ++first)
      for (int p = graph.begin[near[first]]; p < graph.begin[near[first] + 1]; ++p) {
        const int i = graph.neighbour[p];
        if (result.place[i] < 0) near.push_back(i);
        result.place[i] = 0;
      }
  for (int& place : result.place)
    if (place == 0) place = result.size++;
  return result;
}

/// Places in the order of the heights as ever, those of the soft nodes behind them.
std::vector<int> heights_first(const SoftMatrix& matrix, const Surroundings& near) {
  std::vector<int> order;
  for (const int i : matrix.elimination)
    if (i < matrix.heights() && near.place[i] >= 0) order.push_back(near.place[i]);
  for (Index i = matrix.heights(); i < matrix.T.cols(); ++i) order.push_back(near.place[i]);
  return order;
}

/// One flag per place: whether the problem fixes the unknown.
std::vector<uint8_t> fixed_places(const DepthProblem& problem, const Surroundings& near) {
  std::vector<uint8_t> fixed(static_cast<size_t>(near.size), 0);
  for (size_t i = 0; i < problem.variables.fixed.size(); ++i)
    if (near.place[i] >= 0) fixed[near.place[i]] = problem.variables.fixed[i];
  return fixed;
}

SparseMatrix lower_triangle(const Eigen::MatrixXd& A) {
  const auto size = static_cast<int>(A.rows());
  SparseMatrix lower(size, size);
  lower.reserve(A.rows() * (A.rows() + 1) / 2);
  for (int j = 0; j < size; ++j) {
    lower.startVec(j);
    for (int i = j; i < size; ++i) lower.insertBack(i, j) = A(i, j);
  }
  lower.finalize();
  return lower;
}

}  // namespace

SolveStatus BoundStep::prepare(const RunContext& context) {
  if (model_.bound.empty()) return SolveStatus::solved;
  SoftMatrix matrix = make_soft_matrix(model_, problem_, model_.bound);
  direction_ = matrix.direction;
  own_stiffness_ = matrix.own_stiffness;
  springs_ = own_stiffness_;  // any that make the matrix definite
  set_springs(matrix, springs_, matrix.K);
  const Surroundings near = surroundings(matrix);
  const SparseMatrix K = lower_block(matrix.K, near.place, near.size);
  SparseCholesky factor;
  if (!factor.analyse(K, Refactorisation::complete, heights_first(matrix, near), context))
    return SolveStatus::interrupted;
  if (!factor.factorise(K, fixed_places(problem_, near), context))
    return context.cancelled() ? SolveStatus::interrupted : SolveStatus::not_positive_definite;
  std::vector<int> soft(model_.bound.size());
  std::iota(soft.begin(), soft.end(), near.size - static_cast<int>(soft.size()));
  qp_.K = lower_triangle(factor.schur_complement(soft));
  own_diagonal_ = qp_.K.diagonal() - springs_;
  for (const int n : model_.bound) qp_.bounded.push_back(model_.sign[n] != 0);
  factor_.analyse(qp_.K, Refactorisation::incremental);
  return SolveStatus::solved;
}

void BoundStep::renew_springs(const VectorXd& springs) {
  const auto change = (springs - springs_).cwiseAbs().array();
  if ((change <= tolerated_change * (own_stiffness_ + springs_).array()).all()) return;
  springs_ = springs;
  qp_.K.diagonal() = own_diagonal_ + springs;
}

VectorXd BoundStep::even_stiffness() const {
  return model_.lambda_shift * multiply_symmetric(qp_.K, VectorXd::Ones(qp_.K.rows()));
}

SolveStatus BoundStep::move(const VectorXd& slope, const VectorXd& springs,
                            const RunContext& context, VectorXd& f) {
  if (f.size() == 0) return SolveStatus::solved;
  const VectorXd scaled = springs / model_.lambda_shift;
  renew_springs(scaled);
  const VectorXd z = direction_.cwiseProduct(f);
  qp_.b = multiply_symmetric(qp_.K, z) - direction_.cwiseProduct(slope) / model_.lambda_shift;
  BoundQpOptions options;
  options.start_active = active_;
  options.tolerance = step_tolerance;
  const BoundQpSolution solution = solve_bound_qp(qp_, factor_, options, context);
  active_ = solution.active;
  f = direction_.cwiseProduct(solution.z);
  return solution.report.status;
}

}  // namespace relievo
