#include "relief/nonlinear/bound_step.h"

#include <map>
#include <numeric>
#include <utility>

#include "kernel/cholesky/sparse_products.h"
#include "relief/nonlinear/soft_matrix.h"

namespace relievo::relief {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// The matrix serves as long as no spring has changed by so much of the stiffness there.
constexpr double tolerated_change = 0.1;

/// Of loose outlines, times their length: that of a wave of twice the length, and some more.
constexpr double loose_firmness = 2;

/// How often gaps on B may open and close within a step.
constexpr int side_rounds = 8;

/// It only leads the way.
constexpr double step_tolerance = 1e-9;

/// The heights as ever, the soft nodes behind them.
std::vector<int> heights_first(const SoftMatrix& matrix) {
  std::vector<int> order;
  for (const int i : matrix.elimination)
    if (i < matrix.heights()) order.push_back(i);
  for (Index i = matrix.heights(); i < matrix.T.cols(); ++i) order.push_back(static_cast<int>(i));
  return order;
}

/// #B: what share of the loose outline of its range a node stands for; 0 where it is not loose.
VectorXd loose_shares(const NonlinearModel& model) {
  std::map<int, double> length;  // by range
  VectorXd share = model.bound_mass;
  for (Index i = 0; i < share.size(); ++i) {
    if (model.loose_gap[i] < 0) share[i] = 0;
    length[model.bound_ramp[i]] += share[i];
  }
  for (Index i = 0; i < share.size(); ++i)
    if (share[i] > 0) share[i] /= length[model.bound_ramp[i]];
  return share;
}

/// Where gaps are open f is 0, and nothing but the heights resists them.
VectorXd without(const std::vector<uint8_t>& open, VectorXd springs) {
  for (size_t i = 0; i < open.size(); ++i)
    if (open[i] != 0) springs[static_cast<Index>(i)] = 0;
  return springs;
}

SparseMatrix lower_triangle(const MatrixXd& A) {
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

SolveStatus BoundStep::eliminate_heights(const RunContext& context, MatrixXd& K) const {
  SoftMatrix matrix = make_soft_matrix(model_, order_.problem, model_.bound);
  const VectorXd springs = matrix.own_stiffness;  // any that make the matrix definite
  set_springs(matrix, springs, matrix.K);
  std::vector<uint8_t> fixed = order_.problem.variables.fixed;
  fixed.resize(static_cast<size_t>(matrix.T.cols()), 0);
  SparseCholesky factor;
  if (!factor.analyse(matrix.K, Refactorisation::complete, heights_first(matrix), context))
    return SolveStatus::interrupted;
  if (!factor.factorise(matrix.K, fixed, context))
    return context.cancelled() ? SolveStatus::interrupted : SolveStatus::not_positive_definite;
  std::vector<int> soft(model_.bound.size());
  std::iota(soft.begin(), soft.end(), static_cast<int>(matrix.heights()));
  K = factor.schur_complement(soft);
  K.diagonal() -= springs;
  K = matrix.direction.asDiagonal() * K * matrix.direction.asDiagonal();
  return SolveStatus::solved;
}

SolveStatus BoundStep::prepare(const RunContext& context) {
  if (model_.bound.empty()) return SolveStatus::solved;
  MatrixXd K;
  if (const SolveStatus status = eliminate_heights(context, K); status != SolveStatus::solved)
    return status;
  direction_.resize(K.rows());
  for (Index i = 0; i < K.rows(); ++i) direction_[i] = model_.sign[model_.bound[i]] < 0 ? -1 : 1;
  eliminated_ = own_diagonal_ = K.diagonal();
  springs_ = VectorXd::Zero(K.rows());
  qp_.K = lower_triangle(direction_.asDiagonal() * K * direction_.asDiagonal());
  qp_.bounded.clear();
  for (Index i = 0; i < K.rows(); ++i)
    qp_.bounded.push_back(model_.sign[model_.bound[i]] != 0 && model_.loose_gap[i] < 0);
  factor_.analyse(qp_.K, Refactorisation::incremental);
  return SolveStatus::solved;
}

std::vector<uint8_t> BoundStep::open_at(const VectorXd& z) const {
  std::vector<uint8_t> open(model_.bound.size(), 0);
  for (size_t i = 0; i < open.size(); ++i)
    open[i] = model_.loose_gap[i] >= 0 && z[static_cast<Index>(i)] < 0;
  return open;
}

void BoundStep::renew_springs(const VectorXd& springs) {
  const auto change = (springs - springs_).cwiseAbs().array();
  if ((change <= tolerated_change * (own_diagonal_ + springs_).array()).all()) return;
  springs_ = springs;
  qp_.K.diagonal() = own_diagonal_ + springs;
}

/// Parts that rest on loose B may swing by it when all gaps are open. What they rest on elsewhere
/// holds them then, which the elimination does not know.
void BoundStep::resist(double share) {
  own_diagonal_ = eliminated_ + loose_firmness * loose_shares(model_);
  for (Index i = 0; i < own_diagonal_.size(); ++i) {
    const int n = model_.bound[i];
    own_diagonal_[i] += share * model_.metric.A.coeff(n, n);
  }
  if (own_diagonal_.size() > 0) qp_.K.diagonal() = own_diagonal_ + springs_;
}

SolveStatus BoundStep::move(const VectorXd& slope, const VectorXd& springs,
                            const RunContext& context, VectorXd& f) {
  if (f.size() == 0) return SolveStatus::solved;
  const VectorXd scaled = springs / model_.lambda_shift;
  const VectorXd start = direction_.cwiseProduct(f);
  std::vector<uint8_t> open = open_at(start);
  renew_springs(without(open, scaled));
  VectorXd gradient = direction_.cwiseProduct(slope) / model_.lambda_shift;
  qp_.b = multiply_symmetric(qp_.K, start) - gradient;
  for (int round = 0;; ++round) {
    BoundQpOptions options;
    options.start = start;
    options.start_gradient = gradient;
    options.start_active = active_;
    options.tolerance = step_tolerance;
    options.refine = false;
    const BoundQpSolution solution = solve_bound_qp(qp_, factor_, std::move(options), context);
    if (solution.report.status != SolveStatus::solved) return solution.report.status;
    active_ = solution.active;
    f = direction_.cwiseProduct(solution.z);
    std::vector<uint8_t> now = open_at(solution.z);
    if (now == open || round == side_rounds) return SolveStatus::solved;
    open = std::move(now);
    renew_springs(without(open, scaled));
    gradient = multiply_symmetric(qp_.K, start) - qp_.b;
  }
}

}  // namespace relievo::relief
