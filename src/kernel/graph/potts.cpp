#include "kernel/graph/potts.h"

#include <utility>

#include "kernel/graph/min_cut.h"

namespace relievo {
namespace {

int64_t cost(const PottsProblem& problem, int node, int label) {
  return problem.costs[static_cast<size_t>(node) * problem.label_count + label];
}

/// The cheapest way to change some nodes to `alpha`; those are the source side of a cut.
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
