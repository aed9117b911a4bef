#include "relief/ordering/stacked_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/stacked_parts.h"

namespace relievo {
namespace {

using testing::in_box;
using testing::in_disc;

LayeredMesh disc_between_boxes() {
  return stack_parts(
      testing::grid_mesh(20, 20, 10),
      {in_box({0, 0}, {200, 200}), in_disc({100, 100}, 70), in_box({50, 20}, {150, 180})});
}

StackedNodes stacked_of(const LayeredMesh& mesh) {
  return stacked_nodes(mesh, stacked_faces(mesh, testing::scene_of(mesh)));
}

TEST(StackedNodes, AreThoseInsideNeighboursInTheStack) {
  const LayeredMesh mesh = disc_between_boxes();
  const StackedNodes stacked = stacked_of(mesh);
  ASSERT_FALSE(stacked.pairs.empty());
  for (size_t i = 0; i < stacked.pairs.size(); ++i) {
    const DepthPair& pair = stacked.pairs[i];
    EXPECT_EQ(mesh.node_vertex[pair.lower], mesh.node_vertex[pair.upper]);
    EXPECT_LT(mesh.node_part[pair.lower], mesh.node_part[pair.upper]);
    EXPECT_EQ(mesh.node_role[pair.lower], NodeRole::interior);
    EXPECT_EQ(mesh.node_role[pair.upper], NodeRole::interior);
    if (i > 0) {
      EXPECT_LT(std::pair(stacked.pairs[i - 1].lower, stacked.pairs[i - 1].upper),
                std::pair(pair.lower, pair.upper));
    }
  }
  for (size_t f = 0; f < stacked.faces.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int pair = stacked.of_faces[f][k];
      if (pair < 0) continue;
      EXPECT_EQ(stacked.pairs[pair].lower, mesh.faces[stacked.faces[f].lower][k]);
      EXPECT_EQ(stacked.pairs[pair].upper, mesh.faces[stacked.faces[f].upper][k]);
    }
}

TEST(StackedNodes, GrowByRings) {
  const LayeredMesh mesh = disc_between_boxes();
  const StackedNodes stacked = stacked_of(mesh);
  std::vector<uint8_t> one(stacked.pairs.size(), 0);
  one[one.size() / 2] = 1;
  const std::vector<uint8_t> two_rings = grown(stacked, one, 2);
  EXPECT_EQ(two_rings, grown(stacked, grown(stacked, one, 1), 1));
  EXPECT_EQ(grown(stacked, one, 0), one);
  EXPECT_GT(flagged(stacked, two_rings).size(), 7u);
  EXPECT_LT(flagged(stacked, two_rings).size(), stacked.pairs.size());
  EXPECT_EQ(flags_of(stacked, flagged(stacked, two_rings)), two_rings);
}

TEST(StackedNodes, CrossWhereTheUpperOneIsLower) {
  const LayeredMesh mesh = disc_between_boxes();
  const StackedNodes stacked = stacked_of(mesh);
  std::vector<double> h(mesh.node_vertex.size());
  for (size_t n = 0; n < h.size(); ++n)
    h[n] = mesh.node_part[n] == 1 ? mesh.vertices[mesh.node_vertex[n]].x - 100 : 0;
  const std::vector<uint8_t> flags = crossed(stacked, h, 1e-9);
  for (size_t i = 0; i < flags.size(); ++i) {
    const DepthPair& pair = stacked.pairs[i];
    EXPECT_EQ(flags[i] != 0, h[pair.lower] > h[pair.upper]) << i;
  }
  EXPECT_GT(std::count(flags.begin(), flags.end(), 1), 10);
}

}  // namespace
}  // namespace relievo
