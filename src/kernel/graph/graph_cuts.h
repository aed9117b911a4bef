#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// A graph with two terminals whose cheapest cut is wanted. Capacities are integers, so the result
/// is exact; their sum must stay below 2^62.
class CutGraph {
 public:
  /// Costs that no sensible cut pays.
  static constexpr int64_t forbidden = int64_t{1} << 44;

  explicit CutGraph(int node_count);

  /// Adds to what it costs to put `node` on the source side, or on the sink side.
  void add_costs(int node, int64_t on_source_side, int64_t on_sink_side);

  /// Adds an edge whose capacities are paid when its ends are parted: `forward` where a is on the
  /// source side and b on the sink side, `backward` the other way round.
  void add_edge(int a, int b, int64_t forward, int64_t backward);

  /// Finds a cheapest cut and returns its cost; of several the one with the smallest source side.
  /// Dinic's algorithm (1970): O(V^2 E), near-linear on graphs of areas. Call once.
  int64_t solve();

  /// After solve: whether the node is on the source side.
  bool on_source_side(int node) const { return depth_[node] >= 0; }

 private:
  struct Arc {
    int to;
    int64_t left;
  };

  void connect(int a, int b, int64_t forward, int64_t backward);
  bool measure_depths();
  int64_t push(int node, int64_t flow);

  int source_;
  int sink_;
  std::vector<Arc> arcs_;              ///< arc i and its reverse i ^ 1
  std::vector<std::vector<int>> out_;  ///< [nodes + 2] arcs that leave
  std::vector<int64_t> source_cost_;   ///< [nodes] of being on the source side
  std::vector<int64_t> sink_cost_;     ///< [nodes] of being on the sink side
  std::vector<int> depth_;
  std::vector<size_t> next_;
};

/// Nodes that each take one of a few labels: sum of costs of the labels taken, plus the weights of
/// the edges whose ends differ (the Potts energy).
struct PottsProblem {
  struct Edge {
    int a = 0;
    int b = 0;
    int64_t weight = 0;  ///< >= 0
  };
  int label_count = 0;
  std::vector<int64_t> costs;  ///< [#nodes * label_count], node by node; CutGraph::forbidden bars
  std::vector<Edge> edges;

  int node_count() const { return static_cast<int>(costs.size()) / label_count; }
};

int64_t potts_energy(const PottsProblem& problem, const std::vector<int>& labels);

/// Labels, 0 ... label_count - 1, whose energy no change of any set of nodes to one common label
/// lowers: at most twice the least energy, and exactly it for two labels. Alpha-expansion by exact
/// minimum cuts (Boykov, Veksler, Zabih 2001). Precondition: every node has a label that is not
/// barred.
std::vector<int> minimize_potts(const PottsProblem& problem);

}  // namespace relievo
