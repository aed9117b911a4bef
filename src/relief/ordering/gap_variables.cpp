#include "relief/ordering/gap_variables.h"

#include <algorithm>
#include <utility>

namespace relievo {
namespace {

using Row = std::vector<std::pair<int, double>>;

/// Row of T for each variable: signs of the gaps on the way to the root, and the root.
std::vector<Row> paths_to_roots(const DepthForest& forest, const std::vector<int>& variable,
                                const std::vector<uint8_t>& bounded) {
  std::vector<Row> rows(bounded.size());
  for (size_t v = 0; v < rows.size(); ++v)
    if (bounded[v] == 0) rows[v] = {{static_cast<int>(v), 1.0}};
  for (const DepthGap& gap : forest.gaps) {
    Row& row = rows[variable[gap.child]];
    row = rows[variable[gap.parent]];
    row.push_back({variable[gap.child], gap.sign});
  }
  return rows;
}

SparseMatrix matrix_of_rows(const std::vector<Row>& rows, const std::vector<int>& row_of_node) {
  Eigen::SparseMatrix<double, Eigen::RowMajor, int> T(static_cast<int>(row_of_node.size()),
                                                      static_cast<int>(rows.size()));
  std::vector<Row> sorted = rows;
  for (Row& row : sorted) std::sort(row.begin(), row.end());
  for (size_t n = 0; n < row_of_node.size(); ++n) {
    T.startVec(static_cast<int>(n));
    for (const auto& [column, value] : sorted[row_of_node[n]])
      T.insertBack(static_cast<int>(n), column) = value;
  }
  T.finalize();
  return T;
}

}  // namespace

GapVariables make_gap_variables(const DepthForest& forest) {
  GapVariables result;
  const size_t nodes = forest.representative.size();
  result.variable.resize(nodes);
  int count = 0;
  for (size_t n = 0; n < nodes; ++n) {
    const int representative = forest.representative[n];
    const bool first = representative == static_cast<int>(n);
    result.variable[n] = first ? count++ : result.variable[representative];
  }
  result.bounded.assign(static_cast<size_t>(count), 0);
  for (const DepthGap& gap : forest.gaps) result.bounded[result.variable[gap.child]] = 1;
  result.T =
      matrix_of_rows(paths_to_roots(forest, result.variable, result.bounded), result.variable);
  return result;
}

std::vector<double> heights_from_gaps(const DepthForest& forest, const GapVariables& variables,
                                      const Eigen::VectorXd& root_height, const Eigen::VectorXd& z,
                                      double unit) {
  Eigen::VectorXd height = root_height;
  for (const DepthGap& gap : forest.gaps) {
    const int child = variables.variable[gap.child];
    height[child] = height[variables.variable[gap.parent]] + gap.sign * (z[child] * unit);
  }
  std::vector<double> heights;
  heights.reserve(variables.variable.size());
  for (const int v : variables.variable) heights.push_back(height[v]);
  return heights;
}

}  // namespace relievo
