#include "kernel/meshing/unite_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "support/random_scene.h"

namespace relievo {
namespace {

using testing::Random;

constexpr double unit = 1.0 / 65536;

struct Box {
  std::array<int, 3> low;
  std::array<int, 3> high;

  double volume() const {
    double product = 1;
    for (int k = 0; k < 3; ++k) product *= std::max(0, high[k] - low[k]);
    return product;
  }
};

ClosedMesh mesh_of(const Box& box) {
  ClosedMesh mesh;
  for (int i = 0; i < 8; ++i) {
    std::array<double, 3> p{};
    for (int k = 0; k < 3; ++k) p[k] = ((i >> k) & 1) == 0 ? box.low[k] : box.high[k];
    mesh.points.push_back({p[0], p[1], p[2]});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

double volume_of(const ClosedMesh& mesh) {
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c]));
  return six / 6;
}

/// Returns whether every edge occurs once in each direction.
bool is_closed(const ClosedMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  return std::all_of(uses.begin(), uses.end(), [&uses](const auto& use) {
    const auto back = uses.find({use.first.second, use.first.first});
    return use.second == 1 && back != uses.end() && back->second == 1;
  });
}

Box random_box(Random& random) {
  Box box{};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = random.integer(0, 12);
    box.high[k] = box.low[k] + random.integer(1, 9);
  }
  return box;
}

/// Makes a box with integer coordinates; faces and edges of two such boxes often coincide.
TEST(UniteMeshes, CountsWhatBoxesShareOnce) {
  Random random(7);
  int united = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const Box a = random_box(random);
    const Box b = random_box(random);
    Box shared{};
    int touching = 0;  // axes along which they share a plane alone
    bool apart = false;
    for (int k = 0; k < 3; ++k) {
      shared.low[k] = std::max(a.low[k], b.low[k]);
      shared.high[k] = std::min(a.high[k], b.high[k]);
      touching += shared.low[k] == shared.high[k] ? 1 : 0;
      apart = apart || shared.low[k] > shared.high[k];
    }
    const auto both = unite_meshes(mesh_of(a), mesh_of(b), unit);
    if (!both) {
      // They share only an edge or a corner.
      EXPECT_GE(touching, 2);
      continue;
    }
    ++united;
    EXPECT_TRUE(is_closed(both->mesh));
    EXPECT_EQ(both->filled, 0);
    EXPECT_DOUBLE_EQ(volume_of(both->mesh),
                     a.volume() + b.volume() - (apart ? 0 : shared.volume()));
    if (touching < 2) {
      EXPECT_EQ(both->pieces, apart ? 2 : 1);
    }
  }
  EXPECT_GE(united, 900);
}

TEST(UniteMeshes, TellsWhereTrianglesComeFrom) {
  const ClosedMesh a = mesh_of({{0, 0, 0}, {8, 8, 8}});
  const ClosedMesh b = mesh_of({{4, 3, 5}, {12, 7, 11}});
  const auto both = unite_meshes(a, b, unit);
  ASSERT_TRUE(both.ok());
  std::set<int> meshes;
  for (size_t t = 0; t < both->mesh.triangles.size(); ++t) {
    const auto [mesh, triangle] = both->sources[t];
    meshes.insert(mesh);
    const ClosedMesh& from = mesh == 0 ? a : b;
    const auto& [p, q, r] = from.triangles[triangle];
    const Point3 normal = cross(from.points[q] - from.points[p], from.points[r] - from.points[p]);
    for (const int v : both->mesh.triangles[t])
      EXPECT_EQ(dot(normal, both->mesh.points[v] - from.points[p]), 0);
  }
  EXPECT_EQ(meshes.size(), 2U);
}

TEST(UniteMeshes, FillsHollows) {
  // A cup and its lid.
  const auto lid =
      unite_meshes(mesh_of({{0, 0, 0}, {9, 9, 3}}), mesh_of({{0, 0, 0}, {3, 9, 9}}), unit);
  ASSERT_TRUE(lid.ok());
  auto cup = unite_meshes(lid->mesh, mesh_of({{6, 0, 0}, {9, 9, 9}}), unit);
  ASSERT_TRUE(cup.ok());
  for (const Box& wall : {Box{{0, 0, 0}, {9, 3, 9}}, Box{{0, 6, 0}, {9, 9, 9}}}) {
    cup = unite_meshes(cup->mesh, mesh_of(wall), unit);
    ASSERT_TRUE(cup.ok());
    EXPECT_EQ(cup->filled, 0);
  }
  EXPECT_EQ(volume_of(cup->mesh), 729 - 54);
  const auto closed = unite_meshes(cup->mesh, mesh_of({{0, 0, 6}, {9, 9, 9}}), unit);
  ASSERT_TRUE(closed.ok());
  EXPECT_EQ(closed->filled, 27);
  EXPECT_EQ(closed->pieces, 1);
  EXPECT_EQ(volume_of(closed->mesh), 729);
}

}  // namespace
}  // namespace relievo
