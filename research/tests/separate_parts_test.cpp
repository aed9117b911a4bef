#include "research/rivals/separate_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "relief/layers/layered_mesh.h"
#include "research/tests/rival_case.h"
#include "support/random_limbs.h"
#include "support/scenes.h"

namespace relievo::research {
namespace {

/// A disc on a disc, joined along a part of its outline: a bump.
Scene nose() {
  Scene scene = testing::canvas();
  scene.parts = {testing::part("head", testing::circle({200, 200}, 150)),
                 testing::part("nose", testing::circle({200, 200}, 50))};
  scene.joins = {{1, 0, {{200, 150}, {236, 164}, {250, 200}}}};
  return scene;
}

std::set<int> parts_of_surface(const relief::LayeredMesh& mesh, int surface) {
  const std::vector<int> surfaces = relief::joined_surfaces(mesh);
  std::set<int> parts;
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (surfaces[mesh.faces[f][0]] == surface) parts.insert(mesh.face_part[f]);
  return parts;
}

TEST(SeparateParts, LeavesNoTwoPartsOnOneSurface) {
  for (const Scene& scene : {testing::body_and_leg(), testing::random_limbs(5), nose()}) {
    const relief::LayeredMesh mesh = separate_parts(layered(scene), Roots::closed).mesh;
    const std::vector<int> surfaces = relief::joined_surfaces(mesh);
    for (const int surface : std::set<int>(surfaces.begin(), surfaces.end()))
      ASSERT_EQ(parts_of_surface(mesh, surface).size(), 1U);
  }
}

TEST(SeparateParts, GivesEveryPartItsWholeArea) {
  const relief::LayeredMesh joined = layered(nose());
  const relief::LayeredMesh mesh = separate_parts(joined, Roots::closed).mesh;
  EXPECT_EQ(mesh.triangles, joined.triangles);
  // Below the nose the head was gone.
  EXPECT_GT(mesh.faces.size(), joined.faces.size());
  EXPECT_EQ(std::count(mesh.face_part.begin(), mesh.face_part.end(), 0),
            static_cast<std::ptrdiff_t>(mesh.triangles.size()));
}

TEST(SeparateParts, HoldsOutlinesDownAndOpensRootsOnRequest) {
  const relief::LayeredMesh joined = layered(testing::body_and_leg());
  const auto count = [&](Roots roots, relief::NodeRole role) {
    const relief::LayeredMesh mesh = separate_parts(joined, roots).mesh;
    return std::count(mesh.node_role.begin(), mesh.node_role.end(), role);
  };
  EXPECT_EQ(count(Roots::closed, relief::NodeRole::seam), 0);
  const auto opened = count(Roots::open, relief::NodeRole::seam);
  EXPECT_GT(opened, 2);
  EXPECT_EQ(count(Roots::open, relief::NodeRole::outline) + opened,
            count(Roots::closed, relief::NodeRole::outline));
}

TEST(SeparateParts, TiesRootsToWhatLiesThere) {
  const relief::LayeredMesh joined = layered(testing::body_and_leg());
  const relief::LayeredMesh open = separate_parts(joined, Roots::open).mesh;
  int ties = 0;
  for (const relief::DepthPair& pair : open.constraints) {
    EXPECT_EQ(open.node_vertex[pair.lower], open.node_vertex[pair.upper]);
    EXPECT_LT(open.node_part[pair.lower], open.node_part[pair.upper]);
    ties += pair.equal ? 1 : 0;
  }
  const auto opened =
      std::count(open.node_role.begin(), open.node_role.end(), relief::NodeRole::seam);
  EXPECT_EQ(ties, opened + 2);  // both ends as well
  for (const relief::DepthPair& pair : separate_parts(joined, Roots::closed).mesh.constraints)
    EXPECT_FALSE(pair.equal);
}

}  // namespace
}  // namespace relievo::research
