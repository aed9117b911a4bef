#include "relief/joint/bound_step.h"

#include <numeric>

#include "relief/joint/soft_matrix.h"

namespace relievo {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// The matrix serves as long as no spring has changed by so much of the stiffness there.
constexpr double tolerated_change = 0.1;

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
  SparseCholesky factor;
  if (!factor.analyse(matrix.K, Refactorisation::complete, heights_first(matrix), context))
    return SolveStatus::interrupted;
  std::vector<uint8_t> fixed = problem_.variables.fixed;
  fixed.resize(static_cast<size_t>(matrix.T.cols()), 0);
  if (!factor.factorise(matrix.K, fixed, context))
    return context.cancelled() ? SolveStatus::interrupted : SolveStatus::not_positive_definite;
  std::vector<int> soft(model_.bound.size());
  std::iota(soft.begin(), soft.end(), static_cast<int>(matrix.heights()));
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

VectorXd BoundStep::stiffness_against(const VectorXd& change) const {
  const VectorXd K_z = multiply_symmetric(qp_.K, direction_.cwiseProduct(change));
  return model_.lambda_shift * direction_.cwiseProduct(K_z);
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
