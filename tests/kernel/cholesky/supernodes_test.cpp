#include "kernel/cholesky/supernodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "support/sparse_patterns.h"

namespace relievo {
namespace {

std::vector<int> natural_order(const SparseMatrix& A) {
  std::vector<int> order(static_cast<size_t>(A.rows()));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::set<int> rows_below(const Supernodes& fronts, int s) {
  const auto begin = fronts.row.begin() + fronts.row_begin[s];
  return {begin + fronts.columns(s), begin + fronts.rows(s)};
}

TEST(Supernodes, PartitionTheColumnsOfAPermutation) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    const Supernodes fronts = make_supernodes(make_symmetric_graph(lower), natural_order(lower));
    std::vector<int> sorted = fronts.order;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, natural_order(lower)) << name;
    ASSERT_EQ(fronts.column_begin.front(), 0) << name;
    ASSERT_EQ(fronts.column_begin.back(), lower.rows()) << name;
    for (int s = 0; s < fronts.size(); ++s) {
      EXPECT_GT(fronts.columns(s), 0) << name;
      for (int c = 0; c < fronts.columns(s); ++c)
        EXPECT_EQ(fronts.row[fronts.row_begin[s] + c], fronts.column_begin[s] + c) << name;
      EXPECT_TRUE(std::is_sorted(fronts.row.begin() + fronts.row_begin[s],
                                 fronts.row.begin() + fronts.row_begin[s + 1]))
          << name;
    }
  }
}

TEST(Supernodes, FrontsHoldAllThatTheyReceive) {
  for (const auto& [name, lower] : testing::telling_matrices()) {
    const Supernodes fronts = make_supernodes(make_symmetric_graph(lower), natural_order(lower));
    std::vector<int> position(fronts.order.size());
    std::vector<int> front_of(fronts.order.size());
    for (size_t i = 0; i < position.size(); ++i) position[fronts.order[i]] = static_cast<int>(i);
    for (int s = 0; s < fronts.size(); ++s)
      for (int c = fronts.column_begin[s]; c < fronts.column_begin[s + 1]; ++c) front_of[c] = s;
    for (int j = 0; j < lower.outerSize(); ++j)
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
        const auto [column, row] = std::minmax({position[j], position[entry.row()]});
        const int s = front_of[column];
        EXPECT_TRUE(row < fronts.column_begin[s + 1] || rows_below(fronts, s).count(row) == 1)
            << name;
      }
    for (int s = 0; s < fronts.size(); ++s) {
      const std::set<int> below = rows_below(fronts, s);
      EXPECT_EQ(fronts.parent[s], below.empty() ? -1 : front_of[*below.begin()]) << name;
      for (const int row : below)
        EXPECT_TRUE(front_of[row] == fronts.parent[s] ||
                    rows_below(fronts, fronts.parent[s]).count(row) == 1)
            << name;
    }
  }
}

TEST(Supernodes, ADenseMatrixIsOneFront) {
  const SparseMatrix dense = Eigen::MatrixXd::Ones(30, 30).sparseView();
  EXPECT_EQ(make_supernodes(make_symmetric_graph(SparseMatrix(dense)), natural_order(dense)).size(),
            1);
}

}  // namespace
}  // namespace relievo
