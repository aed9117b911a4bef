#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/ordering/depth_forest.h"

namespace relievo {

/// Heights as h = T z, where z holds for each node its height if it is a root, and else its gap.
struct GapVariables {
  std::vector<uint8_t> bounded;  ///< #N: 1 for gaps that are >= 0
  std::vector<uint8_t> fixed;    ///< #N: 1 for gaps that are 0
  SparseMatrix T;                ///< #N x #N, entries 1, -1 and 0

  bool is_root(int node) const { return bounded[node] == 0 && fixed[node] == 0; }
};

/// A row of T has an entry for each node of the row's group, so that the pattern does not depend on
/// which of them is linked to which. O(N + entries of T).
GapVariables make_gap_variables(const DepthForest& forest);

/// Heights of the nodes from the heights of the roots (read at the roots in `root_height`, #N) and
/// the gaps `z` times `unit` (#N). Adds along the trees, so that no pair of the forest is violated,
/// not even by round-off. O(N).
std::vector<double> heights_from_gaps(const DepthForest& forest, const Eigen::VectorXd& root_height,
                                      const Eigen::VectorXd& z, double unit);

}  // namespace relievo
