#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/solvers/active_set.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/ordering/depth_system.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Newton-like steps of f on B, with the stiffness K_B = S + diag(sigma). S is the stiffness that f
/// on B would have if only equalities fixed the heights. Like the true stiffness it grows with the
/// wave number along B, whatever touches beside B. It is dense and small: #B x #B.
///
/// The steps work on y. At a node without a lifting gap y = f. At a node with one, f >= 0 and gap
/// >= 0 are complementary, and y = f if f > 0, otherwise y = -gap. (All with the sign of the
/// surface.)
class BoundaryStep {
 public:
  /// `depth`: the depth order of the pairs, analysed.
  BoundaryStep(const NonlinearModel& model, const DepthSystem& depth)
      : model_(model), depth_(depth) {}

  /// Computes S: one analysis and one factorisation.
  SolveStatus prepare(const RunContext& context);

  /// Adds diagonal stiffness for contacts that S does not know, which shortens the steps:
  /// `share` of the diagonal of A, and at nodes with a lifting gap that of a wave as long as the
  /// outline of the range that has such gaps. O(#B). Precondition: prepared.
  void add_stiffness(double share);

  /// Moves y (#B) against the gradient. Where u has one sign and no gap lifts f, y does not pass 0.
  /// `gradient`: #B, half the slope of the energy with respect to f; `sigma`: #B, positive,
  /// diagonal stiffness that counts where gaps are closed. O(#B^2), and O(#B^3) to factorise K_B
  /// if sigma has changed much or a gap opens or closes. Precondition: prepared.
  SolveStatus move(const Eigen::VectorXd& gradient, const Eigen::VectorXd& sigma,
                   const RunContext& context, Eigen::VectorXd& y);

 private:
  SolveStatus eliminate_heights(const RunContext& context, Eigen::MatrixXd& S) const;
  /// Returns #B flags: 1 where y says that the gap is open.
  std::vector<uint8_t> open_at(const Eigen::VectorXd& y) const;
  void set_sigma(const Eigen::VectorXd& sigma);

  const NonlinearModel& model_;
  const DepthSystem& depth_;
  Eigen::VectorXd sign_;            ///< #B, unknown = sign y
  Eigen::VectorXd schur_diagonal_;  ///< #B, diagonal of S / lambda_shift
  Eigen::VectorXd diagonal_;        ///< #B, the same with the added stiffness
  Eigen::VectorXd sigma_;           ///< #B, sigma / lambda_shift in K
  BoundQp qp_;                      ///< K = K_B / lambda_shift, all of the lower triangle
  std::vector<uint8_t> active_;
  SparseCholesky factor_;
};

}  // namespace relievo::relief
