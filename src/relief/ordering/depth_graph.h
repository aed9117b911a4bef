#pragma once

#include <utility>
#include <vector>

namespace relievo {

/// Inequalities among k items that are linked to each other, as edges (lower, upper) of a directed
/// graph without loops or repetitions, sorted.
struct DepthGraph {
  int size = 0;
  std::vector<std::pair<int, int>> edges;

  bool is_tree() const { return static_cast<int>(edges.size()) == size - 1; }
};

/// Smallest item of the strongly connected component of each item. O(k^3 / 64).
std::vector<int> strong_components(const DepthGraph& graph);

/// Drops the edges that others imply. Precondition: no directed cycle. O(k^3 / 64).
DepthGraph transitive_reduction(const DepthGraph& graph);

/// The items from the lowest up, consistent with all edges and otherwise by (key, item).
/// Precondition: no directed cycle. O((k + edges) log k).
std::vector<int> linear_order(const DepthGraph& graph, const std::vector<int>& key);

/// A centre of a tree, the smallest if there are two: no item is further away than from any other
/// item. Precondition: is_tree(). O(k).
int tree_centre(const DepthGraph& tree);

}  // namespace relievo
