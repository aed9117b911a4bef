#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kernel/graph/graph_cuts.h"

namespace relievo {
namespace {

struct RandomGraph {
  struct Edge {
    int a, b;
    int64_t forward, backward;
  };
  int nodes = 0;
  std::vector<int64_t> source_costs, sink_costs;
  std::vector<Edge> edges;
};

RandomGraph random_graph(uint32_t seed) {
  std::mt19937 random(seed);
  RandomGraph graph;
  graph.nodes = 1 + static_cast<int>(random() % 9);
  for (int i = 0; i < graph.nodes; ++i) {
    graph.source_costs.push_back(random() % 20);
    graph.sink_costs.push_back(random() % 20);
  }
  for (int a = 0; a < graph.nodes; ++a)
    for (int b = 0; b < a; ++b)
      if (random() % 3 != 0)
        graph.edges.push_back(
            {a, b, static_cast<int64_t>(random() % 12), static_cast<int64_t>(random() % 12)});
  return graph;
}

int64_t cut_cost(const RandomGraph& graph, uint32_t source_side) {
  const auto on_source = [&](int i) { return (source_side >> i & 1) != 0; };
  int64_t cost = 0;
  for (int i = 0; i < graph.nodes; ++i)
    cost += on_source(i) ? graph.source_costs[i] : graph.sink_costs[i];
  for (const RandomGraph::Edge& edge : graph.edges) {
    if (on_source(edge.a) && !on_source(edge.b)) cost += edge.forward;
    if (on_source(edge.b) && !on_source(edge.a)) cost += edge.backward;
  }
  return cost;
}

TEST(MinCut, EqualsTheBestOfAllCuts) {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    const RandomGraph graph = random_graph(seed);
    CutGraph cut(graph.nodes);
    for (int i = 0; i < graph.nodes; ++i)
      cut.add_costs(i, graph.source_costs[i], graph.sink_costs[i]);
    for (const RandomGraph::Edge& edge : graph.edges)
      cut.add_edge(edge.a, edge.b, edge.forward, edge.backward);
    int64_t best = cut_cost(graph, 0);
    for (uint32_t side = 1; side < 1U << graph.nodes; ++side)
      best = std::min(best, cut_cost(graph, side));
    EXPECT_EQ(cut.solve(), best) << "seed " << seed;
    uint32_t side = 0;
    for (int i = 0; i < graph.nodes; ++i) side |= cut.on_source_side(i) ? 1U << i : 0;
    EXPECT_EQ(cut_cost(graph, side), best) << "seed " << seed;
  }
}

TEST(MinCut, CostsAddUpOverCalls) {
  CutGraph cut(1);
  cut.add_costs(0, 5, 0);
  cut.add_costs(0, 0, 7);
  EXPECT_EQ(cut.solve(), 5);
  EXPECT_TRUE(cut.on_source_side(0));
}

TEST(MinCut, BarredSidesAreNotTaken) {
  CutGraph cut(2);
  cut.add_costs(0, CutGraph::forbidden, 0);
  cut.add_costs(1, 0, CutGraph::forbidden);
  cut.add_edge(0, 1, 1000, 1000);
  EXPECT_EQ(cut.solve(), 1000);
  EXPECT_FALSE(cut.on_source_side(0));
  EXPECT_TRUE(cut.on_source_side(1));
}

}  // namespace
}  // namespace relievo
