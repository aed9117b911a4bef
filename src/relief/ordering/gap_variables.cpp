#include "relief/ordering/gap_variables.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace relievo {
namespace {

/// Rows of T for each variable: columns and signs of the gaps on the way to the root, and the root.
/// Row v holds the steps begin[v] .. begin[v] + length[v] - 1, by ascending column.
struct RootPaths {
  std::vector<size_t> begin;
  std::vector<int> length;
  std::vector<std::pair<int, double>> steps;
};

RootPaths paths_to_roots(const DepthForest& forest, const std::vector<int>& variable,
                         const std::vector<uint8_t>& bounded) {
  RootPaths paths;
  paths.begin.resize(bounded.size());
  paths.length.assign(bounded.size(), 1);
  paths.steps.reserve(bounded.size() + forest.gaps.size());
  const auto append = [&](int v, double sign) {
    paths.begin[v] = paths.steps.size();
    paths.steps.push_back({v, sign});
  };
  for (size_t v = 0; v < bounded.size(); ++v)
    if (bounded[v] == 0) append(static_cast<int>(v), 1);
  for (const DepthGap& gap : forest.gaps) {
    const int parent = variable[gap.parent];
    const int child = variable[gap.child];
    append(child, gap.sign);
    for (int i = 0; i < paths.length[parent]; ++i) {
      const auto step = paths.steps[paths.begin[parent] + i];
      paths.steps.push_back(step);
    }
    paths.length[child] += paths.length[parent];
    std::sort(paths.steps.begin() + static_cast<std::ptrdiff_t>(paths.begin[child]),
              paths.steps.end());
  }
  return paths;
}

SparseMatrix matrix_of_rows(const RootPaths& paths, const std::vector<int>& row_of_node) {
  Eigen::SparseMatrix<double, Eigen::RowMajor, int> T(static_cast<int>(row_of_node.size()),
                                                      static_cast<int>(paths.begin.size()));
  T.reserve(static_cast<Eigen::Index>(row_of_node.size() + paths.steps.size()));
  for (size_t n = 0; n < row_of_node.size(); ++n) {
    const int v = row_of_node[n];
    T.startVec(static_cast<int>(n));
    for (size_t i = paths.begin[v]; i < paths.begin[v] + paths.length[v]; ++i)
      T.insertBack(static_cast<int>(n), paths.steps[i].first) = paths.steps[i].second;
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
