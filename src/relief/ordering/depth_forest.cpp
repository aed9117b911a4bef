// Depth pairs h_lower <= h_upper or h_lower = h_upper [P eq 13] as a forest of gaps:
//
//   h_child = h_parent + sign z_child,    z_child >= 0, or z_child = 0
//
//   letter    in the code
//   z >= 0    DepthGap
//   z = 0     DepthGap with `equal`
//
// Pairs that a directed graph implies are dropped (transitive reduction), and nodes of a directed
// cycle are equal (strong components).

#include "relief/ordering/depth_forest.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <queue>
#include <span>
#include <tuple>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
namespace {

/// Returns the inequalities between representatives of equal nodes, by group and without
/// repetitions. `group`: #N.
std::vector<DepthEdge> inequalities(const std::vector<DepthPair>& pairs,
                                    const std::vector<int>& group, DisjointSets& equal) {
  std::vector<DepthEdge> edges;
  for (const DepthPair& pair : pairs) {
    const int lower = equal.find(pair.lower);
    const int upper = equal.find(pair.upper);
    if (lower != upper) edges.push_back({lower, upper});
  }
  std::sort(edges.begin(), edges.end(), [&](const DepthEdge& a, const DepthEdge& b) {
    return std::tie(group[a.first], a) < std::tie(group[b.first], b);
  });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Makes the graph of edges between nodes.
DepthGraph make_graph(std::vector<DepthEdge> edges) {
  std::vector<int> nodes;
  for (const auto& [lower, upper] : edges) {
    nodes.push_back(lower);
    nodes.push_back(upper);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto item_of = [&](int node) {
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
  };
  for (auto& [lower, upper] : edges) {
    lower = item_of(lower);
    upper = item_of(upper);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return {static_cast<int>(nodes.size()), std::move(edges), std::move(nodes)};
}

/// Merges the strongly connected components, in `equal` too.
DepthGraph merge_cycles(const DepthGraph& graph, DisjointSets& equal) {
  const std::vector<int> component = strong_components(graph);
  for (int i = 0; i < graph.size; ++i) equal.unite(graph.nodes[i], graph.nodes[component[i]]);
  std::vector<DepthEdge> edges;
  for (const auto& [lower, upper] : graph.edges)
    if (component[lower] != component[upper])
      edges.push_back({equal.find(graph.nodes[lower]), equal.find(graph.nodes[upper])});
  return make_graph(std::move(edges));
}

/// Puts all items of the graph one above the other.
DepthGraph chain(const DepthGraph& graph, const std::vector<int>& node_part) {
  std::vector<int> parts;
  for (const int node : graph.nodes) parts.push_back(node_part[node]);
  const std::vector<int> order = linear_order(graph, parts);
  DepthGraph result{graph.size, {}, graph.nodes};
  for (size_t i = 0; i + 1 < order.size(); ++i) result.edges.push_back({order[i], order[i + 1]});
  return result;
}

/// Returns a tree that implies the inequalities of a group. Merges cycles in `equal`.
DepthGraph tree_of(std::span<const DepthEdge> edges, const std::vector<int>& node_part,
                   DisjointSets& equal) {
  DepthGraph graph = make_graph({edges.begin(), edges.end()});
  if (graph.is_tree()) return graph;
  graph = transitive_reduction(merge_cycles(graph, equal));
  return graph.size > 0 && !graph.is_tree() ? chain(graph, node_part) : graph;
}

/// Makes the smaller node the root.
DepthGap single_gap(const DepthEdge& edge) {
  const auto [lower, upper] = edge;
  if (lower < upper) return {lower, upper, 1, false};
  return {upper, lower, -1, false};
}

void append_gaps(const DepthGraph& tree, std::vector<DepthGap>& gaps) {
  if (tree.size == 0) return;
  std::vector<std::vector<DepthGap>> from(tree.size);
  for (const auto& [lower, upper] : tree.edges) {
    from[lower].push_back({lower, upper, 1, false});
    from[upper].push_back({upper, lower, -1, false});
  }
  std::vector<uint8_t> reached(tree.size, 0);
  std::vector<int> queue = {tree_centre(tree)};
  reached[queue[0]] = 1;
  for (size_t i = 0; i < queue.size(); ++i)
    for (const DepthGap& gap : from[queue[i]]) {
      if (reached[gap.child] != 0) continue;
      reached[gap.child] = 1;
      queue.push_back(gap.child);
      gaps.push_back({tree.nodes[gap.parent], tree.nodes[gap.child], gap.sign, false});
    }
}

/// A square matrix of bits whose rows can be united quickly.
class BitMatrix {
 public:
  explicit BitMatrix(int size)
      : words_((static_cast<size_t>(size) + 63) / 64), bits_(words_ * static_cast<size_t>(size)) {}

  void set(int row, int column) { word(row, column) |= mask(column); }
  bool test(int row, int column) { return (word(row, column) & mask(column)) != 0; }
  void unite_rows(int into, int from) {
    for (size_t w = 0; w < words_; ++w) bits_[into * words_ + w] |= bits_[from * words_ + w];
  }

 private:
  static uint64_t mask(int column) { return uint64_t{1} << (column % 64); }
  uint64_t& word(int row, int column) { return bits_[row * words_ + column / 64]; }

  size_t words_;
  std::vector<uint64_t> bits_;
};

/// Sets bit (i, j) if a path of at least one edge leads from i up to j.
BitMatrix reachability(const DepthGraph& graph) {
  BitMatrix reach(graph.size);
  for (const auto& [lower, upper] : graph.edges) reach.set(lower, upper);
  for (int via = 0; via < graph.size; ++via)
    for (int from = 0; from < graph.size; ++from)
      if (reach.test(from, via)) reach.unite_rows(from, via);
  return reach;
}

}  // namespace

DepthForest build_depth_forest(const std::vector<int>& node_part,
                               const std::vector<DepthPair>& pairs) {
  DisjointSets equal(static_cast<int>(node_part.size()));
  for (const DepthPair& pair : pairs)
    if (pair.equal) equal.unite(pair.lower, pair.upper);
  DisjointSets linked(static_cast<int>(node_part.size()));
  for (const DepthPair& pair : pairs) linked.unite(pair.lower, pair.upper);
  DepthForest forest;
  for (int n = 0; n < linked.size(); ++n) forest.group.push_back(linked.find(n));

  const std::vector<DepthEdge> edges = inequalities(pairs, forest.group, equal);
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    const int group = forest.group[edges[begin].first];
    while (end < edges.size() && forest.group[edges[end].first] == group) ++end;
    if (end - begin == 1)
      forest.gaps.push_back(single_gap(edges[begin]));
    else
      append_gaps(tree_of({&edges[begin], end - begin}, node_part, equal), forest.gaps);
  }
  for (int n = 0; n < equal.size(); ++n)
    if (equal.find(n) != n) forest.gaps.push_back({equal.find(n), n, 1, true});
  return forest;
}

std::vector<int> strong_components(const DepthGraph& graph) {
  BitMatrix reach = reachability(graph);
  std::vector<int> component(graph.size);
  for (int i = 0; i < graph.size; ++i) {
    component[i] = i;
    for (int j = 0; j < i && component[i] == i; ++j)
      if (reach.test(i, j) && reach.test(j, i)) component[i] = component[j];
  }
  return component;
}

DepthGraph transitive_reduction(const DepthGraph& graph) {
  BitMatrix reach = reachability(graph);
  DepthGraph reduced{graph.size, {}, graph.nodes};
  auto siblings = graph.edges.begin();
  for (auto edge = graph.edges.begin(); edge != graph.edges.end(); ++edge) {
    if (edge->first != siblings->first) siblings = edge;
    bool implied = false;
    for (auto s = siblings; s != graph.edges.end() && s->first == edge->first && !implied; ++s)
      implied = s != edge && reach.test(s->second, edge->second);
    if (!implied) reduced.edges.push_back(*edge);
  }
  return reduced;
}

std::vector<int> linear_order(const DepthGraph& graph, const std::vector<int>& key) {
  std::vector<std::vector<int>> above(graph.size);
  std::vector<int> waiting(graph.size, 0);
  for (const auto& [lower, upper] : graph.edges) {
    above[lower].push_back(upper);
    ++waiting[upper];
  }
  using Entry = std::pair<int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> ready;
  for (int i = 0; i < graph.size; ++i)
    if (waiting[i] == 0) ready.push({key[i], i});
  std::vector<int> order;
  while (!ready.empty()) {
    const int lowest = ready.top().second;
    ready.pop();
    order.push_back(lowest);
    for (const int upper : above[lowest])
      if (--waiting[upper] == 0) ready.push({key[upper], upper});
  }
  assert(static_cast<int>(order.size()) == graph.size);
  return order;
}

int tree_centre(const DepthGraph& tree) {
  std::vector<std::vector<int>> linked(tree.size);
  for (const auto& [lower, upper] : tree.edges) {
    linked[lower].push_back(upper);
    linked[upper].push_back(lower);
  }
  std::vector<int> degree(tree.size);
  std::vector<int> leaves;
  for (int i = 0; i < tree.size; ++i) {
    degree[i] = static_cast<int>(linked[i].size());
    if (degree[i] <= 1) leaves.push_back(i);
  }
  int left = tree.size;
  while (left > 2) {
    left -= static_cast<int>(leaves.size());
    std::vector<int> next;
    for (const int leaf : leaves)
      for (const int other : linked[leaf])
        if (--degree[other] == 1) next.push_back(other);
    leaves = std::move(next);
  }
  return *std::min_element(leaves.begin(), leaves.end());
}

}  // namespace relievo::relief
