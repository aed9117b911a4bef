#pragma once

#include <utility>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::relief {

/// h[child] = h[parent] + sign * gap, with gap = 0 if they must be equal and gap >= 0 otherwise.
struct DepthGap {
  int parent = -1;
  int child = -1;
  int sign = 1;
  bool equal = false;
  friend bool operator==(const DepthGap&, const DepthGap&) = default;
};

/// Depth pairs as a forest of gaps: any heights of the roots with any allowed gaps satisfy all
/// pairs.
struct DepthForest {
  std::vector<int> group;  ///< #N: smallest node that pairs link to the node, through others too
  std::vector<DepthGap> gaps;  ///< a parent comes before its children
};

/// Builds the forest of the pairs. Nodes that are equal, or made so by a cycle (a <= b <= a), hang
/// on the smallest of them. Repeated and implied pairs of the rest are dropped, and each tree is
/// rooted in its middle. If pairs of one base vertex still form an undirected cycle, their nodes
/// become one chain that implies the pairs, in the order of parts as far as the pairs allow: a
/// stronger condition, but a consistent one. `node_part`: #N. O(N + P log P) for P pairs, and
/// k^3 / 64 for k nodes of a vertex that are linked in a cycle.
DepthForest build_depth_forest(const std::vector<int>& node_part,
                               const std::vector<DepthPair>& pairs);

/// An inequality between the lower and the upper one of two nodes or items.
using DepthEdge = std::pair<int, int>;

/// Inequalities among k items that are linked to each other, as a directed graph.
struct DepthGraph {
  int size = 0;                  ///< k
  std::vector<DepthEdge> edges;  ///< sorted, no loops, no repetitions
  std::vector<int> nodes{};      ///< node of each item, ascending; or empty

  bool is_tree() const { return static_cast<int>(edges.size()) == size - 1; }
};

/// Returns the smallest item of the strongly connected component of each item. O(k^3 / 64).
std::vector<int> strong_components(const DepthGraph& graph);

/// Drops the edges that others imply. Precondition: no directed cycle. O(k^3 / 64).
DepthGraph transitive_reduction(const DepthGraph& graph);

/// Sorts the items from the lowest up, consistently with all edges and otherwise by (key, item).
/// Precondition: no directed cycle. O((k + edges) log k).
std::vector<int> linear_order(const DepthGraph& graph, const std::vector<int>& key);

/// Returns the centre of a tree: the item whose farthest item is nearest; the smaller one of two.
/// Precondition: is_tree(). O(k).
int tree_centre(const DepthGraph& tree);

}  // namespace relievo::relief
