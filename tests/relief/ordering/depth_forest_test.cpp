#include "relief/ordering/depth_forest.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

namespace relievo::relief {
namespace {

/// holds[i][j] is true if h[i] <= h[j] follows.
using Closure = std::vector<std::vector<bool>>;

Closure closed(Closure holds) {
  const size_t n = holds.size();
  for (size_t i = 0; i < n; ++i) holds[i][i] = true;
  for (size_t via = 0; via < n; ++via)
    for (size_t i = 0; i < n; ++i)
      for (size_t j = 0; j < n; ++j)
        if (holds[i][via] && holds[via][j]) holds[i][j] = true;
  return holds;
}

Closure closure_of(size_t nodes, const std::vector<DepthPair>& pairs) {
  Closure holds(nodes, std::vector<bool>(nodes, false));
  for (const DepthPair& pair : pairs) {
    holds[pair.lower][pair.upper] = true;
    if (pair.equal) holds[pair.upper][pair.lower] = true;
  }
  return closed(holds);
}

Closure closure_of(const DepthForest& forest) {
  const size_t nodes = forest.group.size();
  Closure holds(nodes, std::vector<bool>(nodes, false));
  for (const DepthGap& gap : forest.gaps) {
    if (gap.equal || gap.sign > 0) holds[gap.parent][gap.child] = true;
    if (gap.equal || gap.sign < 0) holds[gap.child][gap.parent] = true;
  }
  return closed(holds);
}

/// Returns the smallest node that pairs link to each node, in either direction.
std::vector<int> linked_groups(size_t nodes, std::vector<DepthPair> pairs) {
  for (DepthPair& pair : pairs) pair.equal = true;
  const Closure linked = closure_of(nodes, pairs);
  std::vector<int> groups;
  for (size_t n = 0; n < nodes; ++n)
    groups.push_back(
        static_cast<int>(std::find(linked[n].begin(), linked[n].end(), true) - linked[n].begin()));
  return groups;
}

std::vector<DepthPair> random_pairs(int nodes, int count) {
  std::vector<DepthPair> pairs;
  for (int i = 0; i < count; ++i) {
    const int lower = *rc::gen::inRange(0, nodes);
    const int upper = *rc::gen::inRange(0, nodes);
    if (lower != upper) pairs.push_back({lower, upper, *rc::gen::inRange(0, 6) == 0});
  }
  return pairs;
}

/// Checks whether the forest decides the order of all items that it links beyond what is asked.
bool is_chain_where_stronger(const Closure& asked, const Closure& given) {
  for (size_t i = 0; i < asked.size(); ++i)
    for (size_t j = 0; j < asked.size(); ++j) {
      if (!given[i][j] || asked[i][j]) continue;
      for (size_t k = 0; k < asked.size(); ++k) {
        const bool linked = given[i][k] || given[k][i];
        if (linked && !(given[j][k] || given[k][j])) return false;
      }
    }
  return true;
}

TEST(DepthForest, ImpliesAllPairsAndIsStrongerOnlyAsAChain) {
  EXPECT_TRUE(rc::check([] {
    const int nodes = *rc::gen::inRange(2, 9);
    const std::vector<DepthPair> pairs = random_pairs(nodes, *rc::gen::inRange(0, 12));
    std::vector<int> part(static_cast<size_t>(nodes));
    for (int& p : part) p = *rc::gen::inRange(0, 5);
    const DepthForest forest = build_depth_forest(part, pairs);
    const Closure asked = closure_of(part.size(), pairs);
    const Closure given = closure_of(forest);
    const std::vector<int> groups = linked_groups(part.size(), pairs);
    RC_ASSERT(forest.group == groups);
    for (size_t i = 0; i < part.size(); ++i)
      for (size_t j = 0; j < part.size(); ++j) {
        RC_ASSERT(!asked[i][j] || given[i][j]);
        RC_ASSERT((given[i][j] && given[j][i]) == (asked[i][j] && asked[j][i]));
      }
    RC_ASSERT(is_chain_where_stronger(asked, given));
  }));
}

TEST(DepthForest, ParentsComeBeforeChildrenAndEveryChildHasOne) {
  EXPECT_TRUE(rc::check([] {
    const int nodes = *rc::gen::inRange(2, 30);
    const std::vector<DepthPair> pairs = random_pairs(nodes, *rc::gen::inRange(0, 40));
    const DepthForest forest = build_depth_forest(std::vector<int>(nodes, 0), pairs);
    std::set<int> children;
    for (const DepthGap& gap : forest.gaps) {
      RC_ASSERT(children.count(gap.parent) == 0 || gap.parent != gap.child);
      RC_ASSERT(children.insert(gap.child).second);
    }
    std::set<int> placed;
    for (const DepthGap& gap : forest.gaps) {
      RC_ASSERT(children.count(gap.parent) == 0 || placed.count(gap.parent) == 1);
      placed.insert(gap.child);
    }
  }));
}

TEST(DepthForest, DoesNotStrengthenTreesAndImpliedPairs) {
  const std::vector<DepthPair> pairs = {{0, 1, false}, {1, 2, false}, {0, 2, false},
                                        {0, 1, false}, {3, 2, false}, {4, 5, true}};
  const std::vector<int> part = {0, 1, 2, 1, 0, 1};
  const DepthForest forest = build_depth_forest(part, pairs);
  EXPECT_EQ(closure_of(forest), closure_of(part.size(), pairs));
  EXPECT_EQ(forest.gaps.size(), 4u);
  EXPECT_EQ(std::count_if(forest.gaps.begin(), forest.gaps.end(),
                          [](const DepthGap& gap) { return gap.equal; }),
            1);
}

TEST(DepthForest, RootsAStarInItsMiddle) {
  std::vector<DepthPair> pairs;
  for (int lower = 0; lower < 6; ++lower) pairs.push_back({lower, 6, false});
  for (const DepthGap& gap : build_depth_forest({0, 1, 2, 3, 4, 5, 6}, pairs).gaps) {
    EXPECT_EQ(gap.parent, 6);
    EXPECT_EQ(gap.sign, -1);
  }
}

TEST(DepthForest, PutsADiamondInTheOrderOfParts) {
  const std::vector<DepthPair> pairs = {{3, 0, false}, {3, 1, false}, {0, 2, false}, {1, 2, false}};
  const std::vector<int> part = {2, 1, 3, 0};
  const Closure expected =
      closure_of(4, std::vector<DepthPair>{{3, 1, false}, {1, 0, false}, {0, 2, false}});
  EXPECT_EQ(closure_of(build_depth_forest(part, pairs)), expected);
}

TEST(DepthForest, ADiamondFollowsItsPairsWhereTheyOpposeTheParts) {
  const std::vector<DepthPair> pairs = {{0, 1, false}, {0, 2, false}, {1, 3, false}, {2, 3, false}};
  const std::vector<int> part = {9, 1, 2, 0};
  const Closure expected =
      closure_of(4, std::vector<DepthPair>{{0, 1, false}, {1, 2, false}, {2, 3, false}});
  EXPECT_EQ(closure_of(build_depth_forest(part, pairs)), expected);
}

TEST(DepthGraph, HandlesMoreItemsThanAWordHasBits) {
  DepthGraph graph{200, {}};
  for (int i = 0; i + 1 < 200; ++i) {
    graph.edges.push_back({i, i + 1});
    if (i + 2 < 200) graph.edges.push_back({i, i + 2});
  }
  EXPECT_TRUE(transitive_reduction(graph).is_tree());
  EXPECT_EQ(tree_centre(transitive_reduction(graph)), 99);
  graph.edges.push_back({199, 100});
  const std::vector<int> component = strong_components(graph);
  EXPECT_EQ(component[199], 100);
  EXPECT_EQ(component[99], 99);
}

}  // namespace
}  // namespace relievo::relief
