#include "relief/ordering/depth_forest.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <tuple>

#include "kernel/base/disjoint_sets.h"

namespace relievo::relief {
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

/// Bit (i, j) is set where a path of at least one edge leads from i up to j.
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
  DepthGraph reduced{graph.size, {}};
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
