#pragma once

#include <cstdint>
#include <span>

namespace relievo::understanding {

/// A node of a decision tree. A feature up to the threshold leads to the node after this one, a
/// greater one to `right`.
struct TreeNode {
  int8_t feature;  ///< index; -1 in a leaf
  int16_t right;   ///< index of a node; 0 in a leaf
  float value;     ///< threshold; log-odds in a leaf
};

/// Computes the sum of the leaves of all trees that features lead to (Friedman: Greedy function
/// approximation, 2001). `nodes` has one tree after the other. research/learning/regions.py fits
/// trees and writes them as tables. O(trees * depth).
double sum_of_leaves(std::span<const TreeNode> nodes, std::span<const double> features);

}  // namespace relievo::understanding
