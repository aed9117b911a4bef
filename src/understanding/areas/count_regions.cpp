#include "understanding/areas/count_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

#include "kernel/base/exact_functions.h"
#include "understanding/areas/region_features.h"
#include "understanding/areas/region_merging.h"

namespace relievo::understanding {
namespace {

constexpr double smallest_piece = 0.01;  ///< least area of a piece that is divided off, per figure

/// Unites neighbours of one group, the likeliest first. `group`: [#B] regions in different groups,
/// or in 0, stay apart.
Merger unite_likeliest(RegionMerging& regions, const DrawingMeasure& drawing,
                       const std::vector<int>& group) {
  return Merger(regions, [&regions, &group, drawing](int a, int b) {
    if (group[a] == 0 || group[a] != group[b]) return -1.0;
    // The probability, which orders pairs as their odds do and is positive.
    return 1 / (1 + exact::exp(-one_part_odds(regions, drawing, a, b)));
  });
}

/// Unites the basins of every proposed region. Returns 1 for each basin of the figure.
std::vector<int> unite_regions(const Basins& basins, RegionMerging& regions) {
  std::vector<int> first(static_cast<size_t>(basins.region_count) + 1, -1);
  std::vector<int> figure(basins.region.size());
  for (size_t b = 0; b < basins.region.size(); ++b) {
    const int r = basins.region[b];
    figure[b] = r == 0 ? 0 : 1;
    first[r] = first[r] < 0 ? static_cast<int>(b) : regions.unite(first[r], static_cast<int>(b));
  }
  return figure;
}

/// Unites regions, the likeliest first, until `count` are left.
void unite_down_to(int count, Basins& basins) {
  RegionMerging regions(basins);
  const std::vector<int> figure = unite_regions(basins, regions);
  Merger merger = unite_likeliest(regions, measure_drawing(basins), figure);
  for (int left = basins.region_count; left > count && merger.unite_next(); --left) {
  }
  std::vector<int> number(basins.region.size(), 0);
  basins.region_count = 0;
  for (size_t b = 0; b < basins.region.size(); ++b) {
    if (figure[b] == 0) continue;
    int& r = number[regions.region_of(static_cast<int>(b))];
    if (r == 0) r = ++basins.region_count;
    basins.region[b] = r;
  }
}

/// A node of a binary tree of unions; leaves are basins.
struct Node {
  int left = -1;  ///< index of a node; -1 in a basin
  int right = -1;
  int64_t area = 0;  ///< px
  double worth = 0;  ///< probability that both sides are one part
};

/// Unites the basins of each region into trees. Nodes 0 ... #B - 1 are the basins; the roots are
/// those that are below no other node, one for each connected piece of a region.
std::vector<Node> unite_basins(const Basins& basins) {
  RegionMerging regions(basins);
  std::vector<Node> nodes;
  for (const Basin& basin : basins.basins) nodes.push_back({-1, -1, basin.area, 0});
  std::vector<int> node(nodes.size());  // [#B] of the region that a basin stands for
  std::iota(node.begin(), node.end(), 0);
  Merger merger = unite_likeliest(regions, measure_drawing(basins), basins.region);
  while (const auto united = merger.unite_next()) {
    const int left = node[united->a];
    const int right = node[united->b];
    node[united->a] = static_cast<int>(nodes.size());
    nodes.push_back({left, right, nodes[left].area + nodes[right].area, united->worth});
  }
  return nodes;
}

/// Finds the roots of the figure.
std::vector<int> find_roots(const std::vector<Node>& nodes, const Basins& basins) {
  std::vector<uint8_t> is_root(nodes.size(), 1);
  for (const Node& node : nodes)
    if (node.left >= 0) is_root[node.left] = is_root[node.right] = 0;
  for (size_t b = 0; b < basins.region.size(); ++b)
    if (basins.region[b] == 0) is_root[b] = 0;
  std::vector<int> roots;
  for (size_t k = 0; k < nodes.size(); ++k)
    if (is_root[k] != 0) roots.push_back(static_cast<int>(k));
  return roots;
}

/// Returns the highest node, from `at` downwards, of which both sides have at least `least` px; -1
/// where there is none. The smaller sides above it stay with their larger sides.
int divisible(const std::vector<Node>& nodes, int at, double least) {
  while (nodes[at].left >= 0) {
    const Node& node = nodes[at];
    const bool left_is_larger = nodes[node.left].area >= nodes[node.right].area;
    const int larger = left_is_larger ? node.left : node.right;
    const int smaller = left_is_larger ? node.right : node.left;
    if (static_cast<double>(nodes[smaller].area) >= least) return at;
    at = larger;
  }
  return -1;
}

/// Assigns all basins below a node to a region.
void give_to(const std::vector<Node>& nodes, int at, int region, Basins& basins) {
  std::vector<int> open = {at};
  while (!open.empty()) {
    const int k = open.back();
    open.pop_back();
    if (nodes[k].left < 0) {
      basins.region[k] = region;
      continue;
    }
    open.push_back(nodes[k].left);
    open.push_back(nodes[k].right);
  }
}

/// Undoes unions of basins, the least likely first, until there are `count` regions.
void divide_up_to(int count, Basins& basins) {
  const std::vector<Node> nodes = unite_basins(basins);
  const std::vector<int> roots = find_roots(nodes, basins);
  double figure = 0;
  for (const int root : roots) figure += static_cast<double>(nodes[root].area);
  std::priority_queue<std::pair<double, int>> queue;  // the least likely union first
  const auto propose = [&](int root) {
    const int at = divisible(nodes, root, smallest_piece * figure);
    if (at >= 0) queue.push({-nodes[at].worth, at});
  };
  for (const int root : roots) propose(root);
  while (basins.region_count < count && !queue.empty()) {
    const Node& node = nodes[queue.top().second];
    queue.pop();
    const bool left_is_smaller = nodes[node.left].area < nodes[node.right].area;
    give_to(nodes, left_is_smaller ? node.left : node.right, ++basins.region_count, basins);
    propose(node.left);
    propose(node.right);
  }
}

}  // namespace

void count_regions(int count, Basins& basins) {
  if (count < basins.region_count)
    unite_down_to(count, basins);
  else if (count > basins.region_count)
    divide_up_to(count, basins);
}

}  // namespace relievo::understanding
