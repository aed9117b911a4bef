#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kernel/graph/graph_cuts.h"

namespace relievo {
namespace {

PottsProblem random_problem(uint32_t seed, int label_count) {
  std::mt19937 random(seed);
  PottsProblem problem;
  problem.label_count = label_count;
  const int nodes = 2 + static_cast<int>(random() % 5);
  for (int i = 0; i < nodes * label_count; ++i) problem.costs.push_back(random() % 15);
  for (int a = 0; a < nodes; ++a)
    for (int b = 0; b < a; ++b)
      if (random() % 2 == 0) problem.edges.push_back({a, b, static_cast<int64_t>(random() % 10)});
  return problem;
}

int64_t least_energy(const PottsProblem& problem) {
  std::vector<int> labels(static_cast<size_t>(problem.node_count()), 0);
  int64_t best = potts_energy(problem, labels);
  for (size_t i = 0; i < labels.size();) {
    if (++labels[i] == problem.label_count) {
      labels[i++] = 0;
      continue;
    }
    i = 0;
    best = std::min(best, potts_energy(problem, labels));
  }
  return best;
}

TEST(Potts, TwoLabelsAreSolvedExactly) {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    const PottsProblem problem = random_problem(seed, 2);
    EXPECT_EQ(potts_energy(problem, minimize_potts(problem)), least_energy(problem)) << seed;
  }
}

TEST(Potts, ManyLabelsStayWithinTwiceTheLeastEnergy) {
  int exact = 0;
  for (uint32_t seed = 0; seed < 200; ++seed) {
    const PottsProblem problem = random_problem(seed, 3 + static_cast<int>(seed % 2));
    const int64_t least = least_energy(problem);
    const int64_t found = potts_energy(problem, minimize_potts(problem));
    EXPECT_GE(found, least);
    EXPECT_LE(found, 2 * least) << seed;
    exact += found == least ? 1 : 0;
  }
  EXPECT_GT(exact, 180);
}

TEST(Potts, BarredLabelsAreNotTaken) {
  PottsProblem problem;
  problem.label_count = 3;
  const int64_t no = CutGraph::forbidden;
  problem.costs = {no, 0, no, no, no, 0, 0, 0, 0};
  problem.edges = {{0, 1, 1 << 20}, {0, 2, 7}, {1, 2, 5}};
  EXPECT_EQ(minimize_potts(problem), (std::vector<int>{1, 2, 1}));
}

}  // namespace
}  // namespace relievo
