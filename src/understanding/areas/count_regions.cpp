#include "understanding/areas/count_regions.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "understanding/areas/region_merging.h"

namespace relievo::understanding {
namespace {

/// What a border with a line is worth beside an open one, where both sides have one colour.
constexpr double lined_worth = 0.25;
/// Distance of colours, of 255 a channel, from which on they say that areas are two.
constexpr double other_colour = 100;
/// Of the figure: what is smaller is not parted off.
constexpr double smallest_piece = 0.01;

/// How likely two neighbours are one part: how much of their border is open, in sides of the
/// smaller one.
double affinity(const RegionMerging& regions, int a, int b) {
  const double open = regions.open_share(a, b);
  const double likeness = std::max(0.0, 1 - regions.colour_distance(a, b) / other_colour);
  const auto pairs = static_cast<double>(regions.borders(a).at(b).pairs);
  const auto area = static_cast<double>(std::min(regions.region(a).area, regions.region(b).area));
  return pairs * (open + lined_worth * (1 - open) * likeness) / std::sqrt(std::max(1.0, area));
}

/// Unites neighbours of one group, the likeliest first.
class Uniter {
 public:
  /// `group`: [#B]; what is in another group, or in 0, stays apart.
  Uniter(RegionMerging& regions, const std::vector<int>& group) : regions_(regions), group_(group) {
    for (int a = 0; a < regions.count(); ++a)
      if (regions.is_region(a)) propose_all(a);
  }

  /// The next two, by their smallest basins; unites them. {-1, -1} where nothing is left.
  std::pair<int, int> next() {
    while (!queue_.empty()) {
      const auto [worth, minus_a, minus_b] = queue_.top();
      queue_.pop();
      const int a = -minus_a;
      const int b = -minus_b;
      // An entry that later unions made out of date has a newer one.
      if (!regions_.is_region(a) || !regions_.is_region(b) || regions_.borders(a).count(b) == 0 ||
          affinity(regions_, a, b) != worth)
        continue;
      worth_ = worth;
      regions_.unite(a, b);
      propose_all(a);
      return {a, b};
    }
    return {-1, -1};
  }

  /// Affinity of the two that were united last.
  double worth() const { return worth_; }

 private:
  void propose_all(int a) {
    for (const auto& [b, border] : regions_.borders(a))
      if (group_[a] != 0 && group_[a] == group_[b])
        queue_.push({affinity(regions_, a, b), -std::min(a, b), -std::max(a, b)});
  }

  RegionMerging& regions_;
  const std::vector<int>& group_;
  double worth_ = 0;
  std::priority_queue<std::tuple<double, int, int>> queue_;
};

/// Unites the basins of every proposed region. The result: whether each is none of the background.
std::vector<int> unite_regions(const Basins& basins, RegionMerging& regions) {
  std::vector<int> first(static_cast<size_t>(basins.region_count) + 1, -1);
  std::vector<int> figure(basins.region.size());
  for (size_t b = 0; b < basins.region.size(); ++b) {
    const int r = basins.region[b];
    figure[b] = r == 0 ? 0 : 1;
    if (first[r] < 0)
      first[r] = static_cast<int>(b);
    else
      regions.unite(regions.region_of(first[r]), regions.region_of(static_cast<int>(b)));
  }
  return figure;
}

void unite_down_to(int count, Basins& basins) {
  RegionMerging regions(basins);
  const std::vector<int> figure = unite_regions(basins, regions);
  Uniter uniter(regions, figure);
  for (int left = basins.region_count; left > count; --left)
    if (uniter.next().first < 0) break;
  std::vector<int> number(basins.region.size(), 0);
  basins.region_count = 0;
  for (size_t b = 0; b < basins.region.size(); ++b) {
    if (figure[b] == 0) continue;
    int& r = number[regions.region_of(static_cast<int>(b))];
    if (r == 0) r = ++basins.region_count;
    basins.region[b] = r;
  }
}

/// A union of basins, or a basin.
struct Node {
  int left = -1;  ///< node; -1 in a basin
  int right = -1;
  int64_t area = 0;
  double worth = 0;  ///< affinity of both sides
};

/// How the basins of each region were united: nodes 0 ... #B - 1 are basins.
struct Unions {
  std::vector<Node> nodes;
  std::vector<int> roots;  ///< a node for each connected piece of a region
};

Unions unite_basins(const Basins& basins) {
  RegionMerging regions(basins);
  Unions unions;
  std::vector<int> node(basins.basins.size());
  for (size_t b = 0; b < node.size(); ++b) {
    node[b] = static_cast<int>(b);
    unions.nodes.push_back({-1, -1, basins.basins[b].area, 0});
  }
  std::vector<bool> is_root(node.size(), true);
  Uniter uniter(regions, basins.region);
  for (auto [a, b] = uniter.next(); a >= 0; std::tie(a, b) = uniter.next()) {
    Node next{node[a], node[b], 0, 0};
    next.area = unions.nodes[next.left].area + unions.nodes[next.right].area;
    next.worth = uniter.worth();
    is_root[next.left] = is_root[next.right] = false;
    node[a] = static_cast<int>(unions.nodes.size());
    unions.nodes.push_back(next);
    is_root.push_back(true);
  }
  for (size_t k = 0; k < is_root.size(); ++k) {
    const bool background = k < basins.region.size() && basins.region[k] == 0;
    if (is_root[k] && !background) unions.roots.push_back(static_cast<int>(k));
  }
  return unions;
}

/// The highest node at or below one whose sides are both pieces; -1 where there is none. What is
/// smaller stays with the larger side.
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

/// Gives all basins below a node to a region.
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

void divide_up_to(int count, Basins& basins) {
  const Unions unions = unite_basins(basins);
  const std::vector<Node>& nodes = unions.nodes;
  double figure = 0;
  for (const int root : unions.roots) figure += static_cast<double>(nodes[root].area);
  // The least likely union first.
  std::priority_queue<std::pair<double, int>> queue;
  const auto propose = [&](int root) {
    const int at = divisible(nodes, root, smallest_piece * figure);
    if (at >= 0) queue.push({-nodes[at].worth, at});
  };
  for (const int root : unions.roots) propose(root);
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
