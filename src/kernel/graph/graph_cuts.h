#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace relievo {

/// A graph with a source and a sink whose minimum cut is wanted. Capacities are integers, so the
/// result is exact; their sum must stay below 2^62.
class CutGraph {
 public:
  /// A cost that no cut pays if it can be avoided.
  static constexpr int64_t forbidden = int64_t{1} << 44;

  explicit CutGraph(int node_count);

  /// Adds to the costs of `node` being on the source side and on the sink side.
  void add_costs(int node, int64_t on_source_side, int64_t on_sink_side);

  /// Adds an edge. A cut pays `forward` where a is on the source side and b on the sink side, and
  /// `backward` the other way round. Precondition: both are >= 0, and a != b.
  void add_edge(int a, int b, int64_t forward, int64_t backward);

  /// Finds the minimum cut, of several the one with the smallest source side, and returns its cost.
  /// Dinic's algorithm (1970): O(V^2 E), near-linear on graphs of areas. Call it once.
  int64_t solve();

  /// Returns whether the node is on the source side of the cut. Precondition: solve() was called.
  bool on_source_side(int node) const { return depth_[node] >= 0; }

 private:
  /// Sets the distance, in arcs with capacity left, of each node from the source. Returns whether
  /// the sink is reached.
  bool measure_depths();
  /// Pushes up to `flow` from the node towards the sink, and returns how much arrived.
  int64_t push(int node, int64_t flow);

  int source_;
  int sink_;
  std::vector<int> head_;              ///< of each arc; the reverse of arc i is i ^ 1
  std::vector<int64_t> left_;          ///< capacity left of each arc
  std::vector<std::vector<int>> out_;  ///< [nodes + 2] arcs that leave
  std::vector<int64_t> source_cost_;   ///< [nodes] of being on the source side
  std::vector<int64_t> sink_cost_;     ///< [nodes] of being on the sink side
  std::vector<int> depth_;
  std::vector<size_t> next_;
};

/// A labelling problem: each node takes one label. The energy of a labelling is the sum of the
/// costs of the labels taken and of the weights of the edges whose ends differ (the Potts energy).
struct PottsProblem {
  struct Edge {
    int a = 0;
    int b = 0;
    int64_t weight = 0;  ///< >= 0
  };
  int label_count = 0;
  std::vector<int64_t>
      costs;  ///< [#nodes * label_count], node by node; CutGraph::forbidden forbids
  std::vector<Edge> edges;

  int node_count() const { return static_cast<int>(costs.size()) / label_count; }
};

/// Computes the energy of a labelling. O(nodes + edges).
int64_t potts_energy(const PottsProblem& problem, const std::vector<int>& labels);

/// Computes labels 0 .. label_count - 1 of low energy by alpha-expansion (Boykov, Veksler, Zabih
/// 2001): no change of any set of nodes to one common label lowers the energy. It is at most twice
/// the minimum, and the minimum itself for two labels. Precondition: every node has a label that is
/// not forbidden.
std::vector<int> minimize_potts(const PottsProblem& problem);

}  // namespace relievo
