#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

#include "kernel/cholesky/supernodes.h"
#include "support/sparse_patterns.h"

namespace relievo {
namespace {

using BoolMatrix = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// Computes the pattern of the Cholesky factor by eliminating one column after the other.
BoolMatrix filled_pattern(const SparseMatrix& lower) {
  BoolMatrix pattern = BoolMatrix(testing::dense_symmetric(lower).array() != 0);
  const Eigen::Index n = pattern.rows();
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index j = k + 1; j < n; ++j)
      if (pattern(j, k))
        for (Eigen::Index i = j; i < n; ++i) pattern(i, j) = pattern(i, j) || pattern(i, k);
  return pattern;
}

std::vector<int> parents_of(const BoolMatrix& filled) {
  std::vector<int> parent(static_cast<size_t>(filled.rows()), -1);
  for (Eigen::Index j = 0; j < filled.cols(); ++j)
    for (Eigen::Index i = filled.rows() - 1; i > j; --i)
      if (filled(i, j)) parent[j] = static_cast<int>(i);
  return parent;
}

std::vector<int> natural_order(Eigen::Index n) {
  std::vector<int> order(static_cast<size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Returns the lower triangle of A with rows and columns in the given order.
SparseMatrix permuted(const SparseMatrix& lower, const std::vector<int>& order) {
  const Eigen::MatrixXd A = testing::dense_symmetric(lower)(order, order);
  return Eigen::MatrixXd(A.triangularView<Eigen::Lower>()).sparseView(0, -1);
}

TEST(EliminationTree, IsThatOfTheFilledPattern) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    std::vector<int> order = natural_order(lower.rows());
    EXPECT_EQ(elimination_tree(make_symmetric_graph(lower), order),
              parents_of(filled_pattern(lower)))
        << name;
    std::reverse(order.begin(), order.end());
    EXPECT_EQ(elimination_tree(make_symmetric_graph(lower), order),
              parents_of(filled_pattern(permuted(lower, order))))
        << name;
  }
}

TEST(EliminationTree, PostorderKeepsSubtreesTogether) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    const std::vector<int> parent = parents_of(filled_pattern(lower));
    const std::vector<int> order = postorder(parent);
    std::vector<int> position(order.size(), -1);
    for (size_t i = 0; i < order.size(); ++i) position[order[i]] = static_cast<int>(i);
    ASSERT_EQ(std::count(position.begin(), position.end(), -1), 0) << name;
    std::vector<int> size(order.size(), 1);
    std::vector<int> first(position);
    for (const int j : order) {
      EXPECT_EQ(position[j] - first[j] + 1, size[j]) << name;
      if (parent[j] < 0) continue;
      EXPECT_LT(position[j], position[parent[j]]) << name;
      size[parent[j]] += size[j];
      first[parent[j]] = std::min(first[parent[j]], first[j]);
    }
  }
}

TEST(EliminationTree, PostorderOfAPostorderIsTheIdentity) {
  const std::vector<int> parent = {2, 2, 6, 4, 5, 6, -1, 8, -1};
  EXPECT_EQ(postorder(parent), natural_order(9));
}

TEST(EliminationTree, CountsAreThoseOfTheFilledPattern) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    const std::vector<int> order = postorder(parents_of(filled_pattern(lower)));
    const BoolMatrix filled = filled_pattern(permuted(lower, order));
    std::vector<int> expected;
    for (Eigen::Index j = 0; j < filled.cols(); ++j)
      expected.push_back(static_cast<int>(filled.col(j).tail(filled.rows() - j).count()));
    EXPECT_EQ(column_counts(make_symmetric_graph(lower), order, parents_of(filled)), expected)
        << name;
  }
}

}  // namespace
}  // namespace relievo
