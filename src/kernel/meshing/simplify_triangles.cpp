#include "kernel/meshing/simplify_triangles.h"

#include <meshoptimizer.h>

namespace relievo {

std::vector<std::array<int, 3>> simplify_triangles(const std::vector<Point3>& positions,
                                                   const std::vector<std::array<int, 3>>& triangles,
                                                   size_t count, double most_error) {
  if (triangles.size() <= count) return triangles;
  std::vector<std::array<float, 3>> places;
  places.reserve(positions.size());
  for (const Point3 p : positions)
    places.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  std::vector<unsigned> before;
  before.reserve(3 * triangles.size());
  for (const std::array<int, 3>& triangle : triangles)
    for (const int v : triangle) before.push_back(static_cast<unsigned>(v));
  std::vector<unsigned> after(before.size());
  constexpr size_t stride = sizeof places.front();
  const float extent = meshopt_simplifyScale(places.front().data(), places.size(), stride);
  const size_t left = meshopt_simplify(
      after.data(), before.data(), before.size(), places.front().data(), places.size(), stride,
      3 * count, extent > 0 ? static_cast<float>(most_error) / extent : 0, 0, nullptr);
  std::vector<std::array<int, 3>> result(left / 3);
  for (size_t i = 0; i < left; ++i) result[i / 3][i % 3] = static_cast<int>(after[i]);
  return result;
}

}  // namespace relievo
