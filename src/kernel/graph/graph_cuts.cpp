#include "kernel/graph/graph_cuts.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace relievo {
namespace {

int64_t cost(const PottsProblem& problem, int node, int label) {
  return problem.costs[static_cast<size_t>(node) * problem.label_count + label];
}

/// Changes the set of nodes to label `alpha` that lowers the energy most; that set is the source
/// side of a minimum cut.
std::vector<int> expanded(const PottsProblem& problem, const std::vector<int>& labels, int alpha) {
  CutGraph graph(problem.node_count());
  for (int i = 0; i < problem.node_count(); ++i)
    graph.add_costs(i, cost(problem, i, alpha), cost(problem, i, labels[i]));
  for (const PottsProblem::Edge& edge : problem.edges) {
    const int64_t both_keep = labels[edge.a] != labels[edge.b] ? edge.weight : 0;
    const int64_t only_b = labels[edge.a] != alpha ? edge.weight : 0;
    const int64_t only_a = labels[edge.b] != alpha ? edge.weight : 0;
    // both_keep + (only_a - both_keep) x_a - only_a x_b + (only_b + only_a - both_keep) x_b (1-x_a)
    graph.add_costs(edge.a, only_a, both_keep);
    graph.add_costs(edge.b, 0, only_a);
    graph.add_edge(edge.b, edge.a, only_b + only_a - both_keep, 0);
  }
  graph.solve();
  std::vector<int> result = labels;
  for (int i = 0; i < problem.node_count(); ++i)
    if (graph.on_source_side(i)) result[i] = alpha;
  return result;
}

}  // namespace

CutGraph::CutGraph(int node_count)
    : source_(node_count),
      sink_(node_count + 1),
      out_(static_cast<size_t>(node_count) + 2),
      source_cost_(static_cast<size_t>(node_count), 0),
      sink_cost_(static_cast<size_t>(node_count), 0) {}

void CutGraph::add_costs(int node, int64_t on_source_side, int64_t on_sink_side) {
  source_cost_[node] += on_source_side;
  sink_cost_[node] += on_sink_side;
}

void CutGraph::add_edge(int a, int b, int64_t forward, int64_t backward) {
  assert(forward >= 0 && backward >= 0 && a != b);
  const int arc = static_cast<int>(head_.size());
  out_[a].push_back(arc);
  out_[b].push_back(arc + 1);
  head_.insert(head_.end(), {b, a});
  left_.insert(left_.end(), {forward, backward});
}

bool CutGraph::measure_depths() {
  depth_.assign(out_.size(), -1);
  depth_[source_] = 0;
  std::vector<int> queue = {source_};
  for (size_t k = 0; k < queue.size(); ++k)
    for (const int i : out_[queue[k]]) {
      if (left_[i] == 0 || depth_[head_[i]] >= 0) continue;
      depth_[head_[i]] = depth_[queue[k]] + 1;
      queue.push_back(head_[i]);
    }
  return depth_[sink_] >= 0;
}

int64_t CutGraph::push(int node, int64_t flow) {
  if (node == sink_) return flow;
  int64_t pushed = 0;
  for (size_t& k = next_[node]; k < out_[node].size(); ++k) {
    const int i = out_[node][k];
    if (left_[i] == 0 || depth_[head_[i]] != depth_[node] + 1) continue;
    const int64_t part = push(head_[i], std::min(flow - pushed, left_[i]));
    left_[i] -= part;
    left_[i ^ 1] += part;
    pushed += part;
    if (pushed == flow) return pushed;
  }
  return pushed;
}

int64_t CutGraph::solve() {
  int64_t flow = 0;
  for (size_t node = 0; node < source_cost_.size(); ++node) {
    const int64_t difference = sink_cost_[node] - source_cost_[node];
    flow += std::min(sink_cost_[node], source_cost_[node]);
    if (difference > 0) add_edge(source_, static_cast<int>(node), difference, 0);
    if (difference < 0) add_edge(static_cast<int>(node), sink_, -difference, 0);
  }
  while (measure_depths()) {
    next_.assign(out_.size(), 0);
    flow += push(source_, int64_t{1} << 62);
  }
  return flow;
}

int64_t potts_energy(const PottsProblem& problem, const std::vector<int>& labels) {
  int64_t energy = 0;
  for (int i = 0; i < problem.node_count(); ++i) energy += cost(problem, i, labels[i]);
  for (const PottsProblem::Edge& edge : problem.edges)
    if (labels[edge.a] != labels[edge.b]) energy += edge.weight;
  return energy;
}

std::vector<int> minimize_potts(const PottsProblem& problem) {
  // From one common label, the first cut is already the optimum for two.
  std::vector<int> labels(static_cast<size_t>(problem.node_count()), 0);
  int64_t energy = potts_energy(problem, labels);
  int unchanged = 0;
  for (int alpha = 0; unchanged < problem.label_count; alpha = (alpha + 1) % problem.label_count) {
    std::vector<int> candidate = expanded(problem, labels, alpha);
    const int64_t lower = potts_energy(problem, candidate);
    ++unchanged;
    if (lower >= energy) continue;
    energy = lower;
    labels = std::move(candidate);
    unchanged = 1;
  }
  return labels;
}

}  // namespace relievo
