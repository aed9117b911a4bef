#include "relief/ordering/depth_forest.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "kernel/base/disjoint_sets.h"
#include "relief/ordering/depth_graph.h"

namespace relievo {
namespace {

/// h[lower] <= h[upper] between representatives; `group` tells apart what is linked.
struct Edge {
  int group = -1;
  int lower = -1;
  int upper = -1;
  auto key() const { return std::tie(group, lower, upper); }
};

std::vector<Edge> inequalities(const std::vector<DepthPair>& pairs, DisjointSets& linked,
                               DisjointSets& equal) {
  std::vector<Edge> edges;
  for (const DepthPair& pair : pairs) {
    const int lower = equal.find(pair.lower);
    const int upper = equal.find(pair.upper);
    if (lower != upper) edges.push_back({linked.find(lower), lower, upper});
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [](const Edge& a, const Edge& b) { return a.key() == b.key(); }),
              edges.end());
  return edges;
}

/// The inequalities of one group; item i of the graph is node items[i], ascending.
struct Group {
  std::vector<int> items;
  DepthGraph graph;
};

Group make_group(std::vector<std::pair<int, int>> edges) {
  Group group;
  for (const auto& [lower, upper] : edges) {
    group.items.push_back(lower);
    group.items.push_back(upper);
  }
  std::sort(group.items.begin(), group.items.end());
  group.items.erase(std::unique(group.items.begin(), group.items.end()), group.items.end());
  const auto item_of = [&](int node) {
    return static_cast<int>(std::lower_bound(group.items.begin(), group.items.end(), node) -
                            group.items.begin());
  };
  for (auto& [lower, upper] : edges) {
    lower = item_of(lower);
    upper = item_of(upper);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  group.graph = {static_cast<int>(group.items.size()), std::move(edges)};
  return group;
}

/// Merges the strongly connected components, in `equal` too.
Group merge_cycles(const Group& group, DisjointSets& equal) {
  const std::vector<int> component = strong_components(group.graph);
  for (int i = 0; i < group.graph.size; ++i) equal.unite(group.items[i], group.items[component[i]]);
  std::vector<std::pair<int, int>> edges;
  for (const auto& [lower, upper] : group.graph.edges)
    if (component[lower] != component[upper])
      edges.push_back({equal.find(group.items[lower]), equal.find(group.items[upper])});
  return make_group(std::move(edges));
}

/// All items of the group one above the other.
DepthGraph chain(const Group& group, const std::vector<int>& node_part) {
  std::vector<int> parts;
  for (const int node : group.items) parts.push_back(node_part[node]);
  const std::vector<int> order = linear_order(group.graph, parts);
  DepthGraph result{group.graph.size, {}};
  for (size_t i = 0; i + 1 < order.size(); ++i) result.edges.push_back({order[i], order[i + 1]});
  return result;
}

/// The inequalities of a group as a tree that implies them; merges cycles in `equal`.
Group tree_of(std::span<const Edge> edges, const std::vector<int>& node_part, DisjointSets& equal) {
  std::vector<std::pair<int, int>> nodes;
  for (const Edge& edge : edges) nodes.push_back({edge.lower, edge.upper});
  Group group = make_group(std::move(nodes));
  if (group.graph.is_tree()) return group;
  group = merge_cycles(group, equal);
  group.graph = transitive_reduction(group.graph);
  if (group.graph.size > 0 && !group.graph.is_tree()) group.graph = chain(group, node_part);
  return group;
}

/// Of two nodes the smaller is the root.
DepthGap single_gap(const Edge& edge) {
  if (edge.lower < edge.upper) return {edge.lower, edge.upper, 1, false};
  return {edge.upper, edge.lower, -1, false};
}

void append_gaps(const Group& tree, std::vector<DepthGap>& gaps) {
  if (tree.graph.size == 0) return;
  std::vector<std::vector<DepthGap>> from(tree.graph.size);
  for (const auto& [lower, upper] : tree.graph.edges) {
    from[lower].push_back({lower, upper, 1, false});
    from[upper].push_back({upper, lower, -1, false});
  }
  std::vector<uint8_t> reached(tree.graph.size, 0);
  std::vector<int> queue = {tree_centre(tree.graph)};
  reached[queue[0]] = 1;
  for (size_t i = 0; i < queue.size(); ++i)
    for (const DepthGap& gap : from[queue[i]]) {
      if (reached[gap.child] != 0) continue;
      reached[gap.child] = 1;
      queue.push_back(gap.child);
      gaps.push_back({tree.items[gap.parent], tree.items[gap.child], gap.sign, false});
    }
}

}  // namespace

DepthForest build_depth_forest(const std::vector<int>& node_part,
                               const std::vector<DepthPair>& pairs) {
  DisjointSets equal(static_cast<int>(node_part.size()));
  for (const DepthPair& pair : pairs)
    if (pair.equal) equal.unite(pair.lower, pair.upper);
  DisjointSets linked(static_cast<int>(node_part.size()));
  for (const DepthPair& pair : pairs) linked.unite(pair.lower, pair.upper);
  const std::vector<Edge> edges = inequalities(pairs, linked, equal);

  DepthForest forest;
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].group == edges[begin].group) ++end;
    if (end - begin == 1)
      forest.gaps.push_back(single_gap(edges[begin]));
    else
      append_gaps(tree_of({&edges[begin], end - begin}, node_part, equal), forest.gaps);
  }
  for (int n = 0; n < equal.size(); ++n) {
    forest.group.push_back(linked.find(n));
    if (equal.find(n) != n) forest.gaps.push_back({equal.find(n), n, 1, true});
  }
  return forest;
}

}  // namespace relievo
