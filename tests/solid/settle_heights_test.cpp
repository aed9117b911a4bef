#include "solid/settle_heights.h"

#include <gtest/gtest.h>

#include <vector>

namespace relievo {
namespace {

/// Triangles around the origin, the one towards direction i at the height `rim[i]` there and
/// everywhere else at `outer`, every triangle with vertices of its own.
HeightField star(const std::vector<int64_t>& centre, int64_t outer) {
  HeightField field;
  field.points.push_back({0, 0});
  const std::vector<GridPoint> around = {{10, 0},  {7, 7},   {0, 10},  {-7, 7},
                                         {-10, 0}, {-7, -7}, {0, -10}, {7, -7}};
  for (const GridPoint p : around) field.points.push_back(p);
  for (int i = 0; i < 8; ++i) {
    const int first = static_cast<int>(field.vertex_point.size());
    for (const int point : {0, 1 + i, 1 + (i + 1) % 8}) {
      field.vertex_point.push_back(point);
      field.vertex_height.push_back(point == 0 ? centre[i] : outer);
      field.normals.push_back({0, 0, 1});
      field.uvs.push_back({});
    }
    field.triangles.push_back({first, first + 1, first + 2});
    field.triangle_part.push_back(0);
  }
  return field;
}

std::vector<int64_t> settled(std::vector<int64_t> centre) {
  HeightField field = star(centre, 5);
  settle_heights(connect_field(field), field);
  for (size_t i = 0; i < centre.size(); ++i) centre[i] = field.vertex_height[3 * i];
  return centre;
}

TEST(SettleHeights, LeavesOneHillAsItIs) {
  const std::vector<int64_t> hill = {1, 2, 3, 9, 9, 4, 2, 2};
  EXPECT_EQ(settled(hill), hill);
  const std::vector<int64_t> flat(8, 4);
  EXPECT_EQ(settled(flat), flat);
}

TEST(SettleHeights, FillsValleysBetweenTwoHills) {
  EXPECT_EQ(settled({9, 1, 1, 1, 9, 2, 2, 2}), (std::vector<int64_t>{9, 1, 1, 1, 9, 9, 9, 9}));
  EXPECT_EQ(settled({8, 1, 1, 6, 3, 7, 2, 8}), (std::vector<int64_t>{8, 1, 1, 6, 6, 7, 7, 8}));
}

TEST(SettleHeights, LetsNoTwoSidesChangePlaces) {
  HeightField field;
  field.points = {{0, 0}, {10, 0}, {5, 8}, {5, -8}};
  field.vertex_point = {0, 1, 2, 1, 0, 3};
  field.vertex_height = {9, 3, 5, 7, 2, 5};
  field.normals.assign(6, {0, 0, 1});
  field.uvs.assign(6, {});
  field.triangles = {{0, 1, 2}, {3, 4, 5}};
  field.triangle_part = {0, 0};
  settle_heights(connect_field(field), field);
  EXPECT_EQ(field.vertex_height, (std::vector<int64_t>{9, 7, 5, 7, 2, 5}));
}

}  // namespace
}  // namespace relievo
