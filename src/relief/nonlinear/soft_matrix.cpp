#include "relief/nonlinear/soft_matrix.h"

#include <cstdint>

#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

/// Columns of T and one more for each soft node.
SparseMatrix with_soft_columns(const SparseMatrix& T, const std::vector<int>& soft,
                               const Eigen::VectorXd& direction) {
  const auto heights = static_cast<int>(T.cols());
  SparseMatrix wide(static_cast<int>(T.rows()), heights + static_cast<int>(soft.size()));
  wide.reserve(T.nonZeros() + static_cast<Eigen::Index>(soft.size()));
  for (int j = 0; j < heights; ++j) {
    wide.startVec(j);
    for (SparseMatrix::InnerIterator entry(T, j); entry; ++entry)
      wide.insertBack(static_cast<int>(entry.row()), j) = entry.value();
  }
  for (int i = 0; i < static_cast<int>(soft.size()); ++i) {
    wide.startVec(heights + i);
    wide.insertBack(soft[i], heights + i) = -direction[i];
  }
  wide.finalize();
  return wide;
}

/// The unknowns of the nodes and the soft ones' f in the order of elimination.
std::vector<int> order_of_unknowns(const NonlinearModel& model, const std::vector<int>& soft) {
  std::vector<int> soft_place(model.elimination.size(), -1);
  auto unknowns = static_cast<int>(model.elimination.size());
  for (const int n : soft) soft_place[n] = unknowns++;
  std::vector<int> order;
  order.reserve(static_cast<size_t>(unknowns));
  for (const int n : model.elimination) {
    order.push_back(n);
    if (soft_place[n] >= 0) order.push_back(soft_place[n]);
  }
  return order;
}

}  // namespace

SoftMatrix make_soft_matrix(const NonlinearModel& model, const DepthProblem& problem,
                            const std::vector<int>& soft) {
  SoftMatrix matrix;
  const auto softs = static_cast<Eigen::Index>(soft.size());
  matrix.direction.resize(softs);
  for (Eigen::Index i = 0; i < softs; ++i) matrix.direction[i] = model.sign[soft[i]] < 0 ? -1 : 1;
  matrix.T = with_soft_columns(problem.variables.T, soft, matrix.direction);
  matrix.K = galerkin_lower(model.metric.A, matrix.T);
  matrix.own_stiffness = matrix.K.diagonal().tail(softs);
  matrix.elimination = order_of_unknowns(model, soft);
  return matrix;
}

void set_springs(const SoftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K) {
  const Eigen::Index heights = matrix.heights();
  for (Eigen::Index i = 0; i < stiffness.size(); ++i) {
    const auto j = static_cast<int>(heights + i);
    K.coeffRef(j, j) = matrix.own_stiffness[i] + stiffness[i];
  }
}

}  // namespace relievo::relief
