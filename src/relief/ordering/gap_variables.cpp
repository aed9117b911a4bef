#include "relief/ordering/gap_variables.h"

#include <cstddef>

namespace relievo {
namespace {

/// Where the entries of T are: those of column n are in the rows of n's group, ascending.
struct GroupPattern {
  std::vector<int> place;  ///< #N: of the node in its group
  std::vector<int> size;   ///< #N: of the group, at its smallest node
};

GroupPattern pattern_of(const std::vector<int>& group) {
  GroupPattern pattern;
  pattern.size.assign(group.size(), 0);
  pattern.place.reserve(group.size());
  for (const int smallest : group) pattern.place.push_back(pattern.size[smallest]++);
  return pattern;
}

/// T with all its entries 0.
SparseMatrix empty_matrix(const std::vector<int>& group, const GroupPattern& pattern) {
  const auto nodes = static_cast<int>(group.size());
  SparseMatrix T(nodes, nodes);
  int* begin = T.outerIndexPtr();
  for (int n = 0; n < nodes; ++n) begin[n + 1] = begin[n] + pattern.size[group[n]];
  T.resizeNonZeros(begin[nodes]);
  // All columns of a group have the same rows: each node writes itself into the first one, and the
  // others copy it once it is complete.
  for (int n = 0; n < nodes; ++n) T.innerIndexPtr()[begin[group[n]] + pattern.place[n]] = n;
  for (int n = 0; n < nodes; ++n)
    for (int i = 0; i < pattern.size[group[n]]; ++i)
      T.innerIndexPtr()[begin[n] + i] = T.innerIndexPtr()[begin[group[n]] + i];
  T.coeffs().setZero();
  return T;
}

}  // namespace

GapVariables make_gap_variables(const DepthForest& forest) {
  const size_t nodes = forest.group.size();
  GapVariables result;
  result.bounded.assign(nodes, 0);
  result.fixed.assign(nodes, 0);
  std::vector<int> parent(nodes, -1);
  std::vector<double> sign(nodes, 1);
  for (const DepthGap& gap : forest.gaps) {
    (gap.equal ? result.fixed : result.bounded)[gap.child] = 1;
    parent[gap.child] = gap.parent;
    sign[gap.child] = gap.sign;
  }
  const GroupPattern pattern = pattern_of(forest.group);
  result.T = empty_matrix(forest.group, pattern);
  for (size_t n = 0; n < nodes; ++n)
    for (int on_way = static_cast<int>(n); on_way >= 0; on_way = parent[on_way])
      result.T.valuePtr()[result.T.outerIndexPtr()[on_way] + pattern.place[n]] = sign[on_way];
  return result;
}

std::vector<double> heights_from_gaps(const DepthForest& forest, const Eigen::VectorXd& root_height,
                                      const Eigen::VectorXd& z, double unit) {
  std::vector<double> height(root_height.begin(), root_height.end());
  for (const DepthGap& gap : forest.gaps)
    height[gap.child] = height[gap.parent] + gap.sign * (z[gap.child] * unit);
  return height;
}

}  // namespace relievo
