#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::relief {

/// h[child] = h[parent] + sign * gap with gap >= 0, and gap = 0 where they are to be equal.
struct DepthGap {
  int parent = -1;
  int child = -1;
  int sign = 1;
  bool equal = false;
  friend bool operator==(const DepthGap&, const DepthGap&) = default;
};

/// Depth pairs as a forest of gaps: any values for the roots and any gaps as allowed give heights
/// that satisfy all pairs.
struct DepthForest {
  std::vector<int> group;      ///< #N: smallest of the nodes that the node may be linked to
  std::vector<DepthGap> gaps;  ///< a parent comes before its children
};

/// Nodes that are equal, or that a cycle makes equal (a <= b <= a), hang on the smallest of them.
/// Among these, repeated and implied pairs are dropped and the rest is rooted in the middle of each
/// tree. Where pairs of one base vertex still form an undirected cycle, their nodes are put in one
/// chain that implies the pairs, in the order of parts as far as the pairs allow: stronger than
/// asked for, but consistent. Groups are what the pairs link. `node_part` has #N entries.
/// O(N + P log P) for P pairs, and k^3 / 64 where k nodes of a vertex are linked in a cycle.
DepthForest build_depth_forest(const std::vector<int>& node_part,
                               const std::vector<DepthPair>& pairs);

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

}  // namespace relievo::relief
