#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/solvers/bound_qp.h"
#include "relief/nonlinear/nonlinear_model.h"
#include "relief/ordering/depth_problem.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// Steps of f on B against the slope of the energy, by the stiffness that f would have if nothing
/// but equalities held the heights: like that of the energy itself it grows with the wave number
/// along B, whether a part lies on another beside B or not. Eliminating the heights once leaves a
/// small dense matrix.
class BoundStep {
 public:
  /// order: of the pairs, analysed.
  BoundStep(const NonlinearModel& model, const DepthSystem& order) : model_(model), order_(order) {}

  /// Finds the stiffness: one analysis and one factorisation.
  SolveStatus prepare(const RunContext& context);

  /// Makes steps shorter: by a share of what holds each node while all heights beside it are held,
  /// and where B is loose, by what holds a wave as long as the loose outline of the range. O(#B).
  /// Precondition: prepared.
  void resist(double share);

  /// Takes f (#B) to the next one; where u has one sign, it does not pass 0, but at loose nodes,
  /// where -f is then the gap. `slope`: #B, of the energy / 2 with respect to f; `springs`: #B,
  /// what else resists f, positive, at loose nodes as long as their gaps are closed. O(#B^2), or
  /// O(#B^3) where the springs are no longer those of the last call, as whenever a gap opens or
  /// closes. Precondition: prepared.
  SolveStatus move(const Eigen::VectorXd& slope, const Eigen::VectorXd& springs,
                   const RunContext& context, Eigen::VectorXd& f);

 private:
  SolveStatus eliminate_heights(const RunContext& context, Eigen::MatrixXd& K) const;
  /// #B: whether the gap is open there.
  std::vector<uint8_t> open_at(const Eigen::VectorXd& z) const;
  void renew_springs(const Eigen::VectorXd& springs);

  const NonlinearModel& model_;
  const DepthSystem& order_;
  Eigen::VectorXd direction_;     ///< #B, f = direction * unknown
  Eigen::VectorXd eliminated_;    ///< #B, the diagonal of what the elimination leaves
  Eigen::VectorXd own_diagonal_;  ///< #B, that of K without springs
  Eigen::VectorXd springs_;       ///< in K, in units of lambda_shift
  BoundQp qp_;                    ///< K is #B x #B, all entries of the lower triangle
  std::vector<uint8_t> active_;
  SparseCholesky factor_;
};

}  // namespace relievo::relief
