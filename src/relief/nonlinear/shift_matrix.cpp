// The shift energy if f is unknown at the free nodes F:
//
//   h = T_0 z,   f_F = sign y,   g = h - f = T (z, y) - known f,   T = [ T_0 | -sign e_F ]
//   1/2 g'A g = 1/2 (z, y)' K (z, y) + linear terms,               K = T'A T
//
//   letter    in the code
//   T_0       DepthSystem::T
//   T, K      ShiftMatrix::T, K
//   F         `nodes`
//   A         ShiftMetric::A

#include "relief/nonlinear/shift_matrix.h"

#include <cstdint>

#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

/// Appends a column for each free node to T.
SparseMatrix with_free_columns(const SparseMatrix& T, const std::vector<int>& nodes,
                               const Eigen::VectorXd& sign) {
  const auto heights = static_cast<int>(T.cols());
  SparseMatrix wide(static_cast<int>(T.rows()), heights + static_cast<int>(nodes.size()));
  wide.reserve(T.nonZeros() + static_cast<Eigen::Index>(nodes.size()));
  for (int j = 0; j < heights; ++j) {
    wide.startVec(j);
    for (SparseMatrix::InnerIterator entry(T, j); entry; ++entry)
      wide.insertBack(static_cast<int>(entry.row()), j) = entry.value();
  }
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    wide.startVec(heights + i);
    wide.insertBack(nodes[i], heights + i) = -sign[i];
  }
  wide.finalize();
  return wide;
}

/// Orders the unknowns as the model orders nodes, y of a node directly after its height or gap.
std::vector<int> order_of_unknowns(const NonlinearModel& model, const std::vector<int>& nodes) {
  std::vector<int> free_unknown(model.elimination.size(), -1);
  auto unknowns = static_cast<int>(model.elimination.size());
  for (const int n : nodes) free_unknown[n] = unknowns++;
  std::vector<int> order;
  order.reserve(static_cast<size_t>(unknowns));
  for (const int n : model.elimination) {
    order.push_back(n);
    if (free_unknown[n] >= 0) order.push_back(free_unknown[n]);
  }
  return order;
}

}  // namespace

ShiftMatrix make_shift_matrix(const NonlinearModel& model, const DepthSystem& depth,
                              const std::vector<int>& nodes) {
  ShiftMatrix matrix;
  const auto count = static_cast<Eigen::Index>(nodes.size());
  matrix.sign.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) matrix.sign[i] = model.sign[nodes[i]] < 0 ? -1 : 1;
  matrix.T = with_free_columns(depth.T, nodes, matrix.sign);
  matrix.K = galerkin_lower(model.metric.A, matrix.T);
  matrix.diagonal = matrix.K.diagonal().tail(count);
  matrix.elimination = order_of_unknowns(model, nodes);
  return matrix;
}

void set_stiffness(const ShiftMatrix& matrix, const Eigen::VectorXd& stiffness, SparseMatrix& K) {
  const Eigen::Index heights = matrix.heights();
  for (Eigen::Index i = 0; i < stiffness.size(); ++i) {
    const auto j = static_cast<int>(heights + i);
    K.coeffRef(j, j) = matrix.diagonal[i] + stiffness[i];
  }
}

}  // namespace relievo::relief
