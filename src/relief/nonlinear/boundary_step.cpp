// The boundary step of the non-linear method: the next f on B, in scene units,
//
//   minimise 1/2 (y - y0)' K_B (y - y0) + e'(y - y0),    K_B = S + diag(sigma)
//   subject to y >= 0 where u has one sign and no gap lifts f
//
// y is f, or -gap at nodes where f >= 0 and a gap >= 0 are complementary. With the heights'
// unknowns Z, B and the matrix K of the shift energy over both (shift_matrix),
//
//   S = lambda_shift (K_BB - K_BZ K_ZZ^-1 K_ZB)                    Schur complement
//   sigma = lambda_bnd m + 2 sgn(f) L_BI s      or with |L_BI s| if that is too small
//   sigma = 0 where the gap is open: f stays 0, and only S acts
//
//   letter          in the code (all / lambda_shift)
//   S               result of eliminate_heights; its diagonal schur_diagonal_
//   sigma           sigma_, from NonlinearMap::sigma_on_boundary
//   K_B             qp_.K, with signs
//   e               gradient, from NonlinearMap::gradient_on_boundary
//   y0, y           start, y in move

#include "relief/nonlinear/boundary_step.h"

#include <map>
#include <numeric>
#include <utility>

#include "kernel/cholesky/sparse_products.h"

namespace relievo::relief {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// The matrix is kept until sigma has changed by this share of the diagonal somewhere.
constexpr double tolerated_change = 0.1;

/// Stiffness of an outline with lifting gaps, times its length: somewhat more than that of a wave
/// of twice its length.
constexpr double gap_stiffness = 2;

/// Largest number of times that gaps on B change sides within a step.
constexpr int side_rounds = 8;

/// A step needs no more digits.
constexpr double step_tolerance = 1e-9;

/// Orders the heights as usual and the free nodes behind them.
std::vector<int> heights_first(const ShiftMatrix& matrix) {
  std::vector<int> order;
  for (const int i : matrix.elimination)
    if (i < matrix.heights()) order.push_back(i);
  for (Index i = matrix.heights(); i < matrix.T.cols(); ++i) order.push_back(static_cast<int>(i));
  return order;
}

/// Returns the share of each node in the outline of its range that has lifting gaps, #B; 0 at nodes
/// without one.
VectorXd lifted_shares(const NonlinearModel& model) {
  std::map<int, double> length;  // by range
  VectorXd share = model.bound_mass;
  for (Index i = 0; i < share.size(); ++i) {
    if (model.lifting_gap[i] < 0) share[i] = 0;
    length[model.bound_ramp[i]] += share[i];
  }
  for (Index i = 0; i < share.size(); ++i)
    if (share[i] > 0) share[i] /= length[model.bound_ramp[i]];
  return share;
}

/// Sets sigma to 0 where the gap is open.
VectorXd where_closed(const std::vector<uint8_t>& open, VectorXd sigma) {
  for (size_t i = 0; i < open.size(); ++i)
    if (open[i] != 0) sigma[static_cast<Index>(i)] = 0;
  return sigma;
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

/// Computes S / lambda_shift for y = f.
SolveStatus BoundaryStep::eliminate_heights(const RunContext& context, MatrixXd& S) const {
  ShiftMatrix matrix = make_shift_matrix(model_, depth_, model_.bound);
  const VectorXd stiffness = matrix.diagonal;  // any that makes the matrix definite
  set_stiffness(matrix, stiffness, matrix.K);
  std::vector<uint8_t> fixed = depth_.qp.fixed;
  fixed.resize(static_cast<size_t>(matrix.T.cols()), 0);
  SparseCholesky factor;
  if (!factor.analyse(matrix.K, Refactorisation::complete, heights_first(matrix), context))
    return SolveStatus::interrupted;
  if (!factor.factorise(matrix.K, fixed, context))
    return context.cancelled() ? SolveStatus::interrupted : SolveStatus::not_positive_definite;
  std::vector<int> unknowns(model_.bound.size());
  std::iota(unknowns.begin(), unknowns.end(), static_cast<int>(matrix.heights()));
  S = factor.schur_complement(unknowns);
  S.diagonal() -= stiffness;
  S = matrix.sign.asDiagonal() * S * matrix.sign.asDiagonal();
  return SolveStatus::solved;
}

SolveStatus BoundaryStep::prepare(const RunContext& context) {
  if (model_.bound.empty()) return SolveStatus::solved;
  MatrixXd S;
  if (const SolveStatus status = eliminate_heights(context, S); status != SolveStatus::solved)
    return status;
  sign_.resize(S.rows());
  for (Index i = 0; i < S.rows(); ++i) sign_[i] = model_.sign[model_.bound[i]] < 0 ? -1 : 1;
  schur_diagonal_ = diagonal_ = S.diagonal();
  sigma_ = VectorXd::Zero(S.rows());
  qp_.K = lower_triangle(sign_.asDiagonal() * S * sign_.asDiagonal());
  qp_.bounded.clear();
  for (Index i = 0; i < S.rows(); ++i)
    qp_.bounded.push_back(model_.sign[model_.bound[i]] != 0 && model_.lifting_gap[i] < 0);
  factor_.analyse(qp_.K, Refactorisation::incremental);
  return SolveStatus::solved;
}

std::vector<uint8_t> BoundaryStep::open_at(const VectorXd& y) const {
  std::vector<uint8_t> open(model_.bound.size(), 0);
  for (size_t i = 0; i < open.size(); ++i)
    open[i] = model_.lifting_gap[i] >= 0 && y[static_cast<Index>(i)] < 0;
  return open;
}

void BoundaryStep::set_sigma(const VectorXd& sigma) {
  const auto change = (sigma - sigma_).cwiseAbs().array();
  if ((change <= tolerated_change * (diagonal_ + sigma_).array()).all()) return;
  sigma_ = sigma;
  qp_.K.diagonal() = diagonal_ + sigma;
}

/// A part that rests on B by lifting gaps alone may swing when all of them are open. Contacts
/// elsewhere stop it, which S does not know.
void BoundaryStep::add_stiffness(double share) {
  diagonal_ = schur_diagonal_ + gap_stiffness * lifted_shares(model_);
  for (Index i = 0; i < diagonal_.size(); ++i) {
    const int n = model_.bound[i];
    diagonal_[i] += share * model_.metric.A.coeff(n, n);
  }
  if (diagonal_.size() > 0) qp_.K.diagonal() = diagonal_ + sigma_;
}

SolveStatus BoundaryStep::move(const VectorXd& gradient, const VectorXd& sigma,
                               const RunContext& context, VectorXd& y) {
  if (y.size() == 0) return SolveStatus::solved;
  const VectorXd scaled = sigma / model_.lambda_shift;
  const VectorXd start = sign_.cwiseProduct(y);
  std::vector<uint8_t> open = open_at(start);
  set_sigma(where_closed(open, scaled));
  VectorXd start_gradient = sign_.cwiseProduct(gradient) / model_.lambda_shift;
  qp_.b = multiply_symmetric(qp_.K, start) - start_gradient;
  for (int round = 0;; ++round) {
    BoundQpOptions options;
    options.start = start;
    options.start_gradient = start_gradient;
    options.start_active = active_;
    options.tolerance = step_tolerance;
    options.refine = false;
    const BoundQpSolution solution = solve_bound_qp(qp_, factor_, std::move(options), context);
    if (solution.report.status != SolveStatus::solved) return solution.report.status;
    active_ = solution.active;
    y = sign_.cwiseProduct(solution.z);
    std::vector<uint8_t> now = open_at(solution.z);
    if (now == open || round == side_rounds) return SolveStatus::solved;
    open = std::move(now);
    set_sigma(where_closed(open, scaled));
    start_gradient = multiply_symmetric(qp_.K, start) - qp_.b;
  }
}

}  // namespace relievo::relief
