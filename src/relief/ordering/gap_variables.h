#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "relief/ordering/depth_forest.h"

namespace relievo {

/// Heights as h = T z, where z holds the height of each root and each gap. One variable for each
/// representative, in the order of nodes.
struct GapVariables {
  std::vector<int> variable;     ///< #N: variable of the node's representative
  std::vector<uint8_t> bounded;  ///< #M: 1 for gaps, which are >= 0
  SparseMatrix T;                ///< #N x #M, entries 1 and -1
};

/// O(N + entries of T); a row of T is as long as the node is deep in its tree.
GapVariables make_gap_variables(const DepthForest& forest);

/// Heights of the nodes from the heights of the roots (read at the roots' variables of
/// `root_height`, #M) and the gaps `z` times `unit` (#M). Adds along the trees, so that no pair
/// of the forest is violated, not even by round-off. O(N).
std::vector<double> heights_from_gaps(const DepthForest& forest, const GapVariables& variables,
                                      const Eigen::VectorXd& root_height, const Eigen::VectorXd& z,
                                      double unit);

}  // namespace relievo
