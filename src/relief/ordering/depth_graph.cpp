#include "relief/ordering/depth_graph.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <functional>
#include <queue>

namespace relievo {
namespace {

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

}  // namespace relievo
