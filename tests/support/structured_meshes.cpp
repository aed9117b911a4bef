#include "support/structured_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace relievo::testing {
namespace {

int ring_begin(int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); }

int ring_vertex(int ring, int i) { return ring == 0 ? 0 : ring_begin(ring) + i % (6 * ring); }

Point2 direction(int i, int count) {
  const double angle = 2 * std::numbers::pi * i / count;
  return {std::cos(angle), std::sin(angle)};
}

/// Vertex i of 6 * ring that are spread evenly over the sides of the unit hexagon.
Point2 on_hexagon(int i, int ring) {
  const double along = static_cast<double>(i % ring) / ring;
  return (1 - along) * direction(i / ring, 6) + along * direction(i / ring + 1, 6);
}

}  // namespace

PlanarMesh disc_mesh(double radius, int rings) {
  PlanarMesh mesh;
  mesh.vertices.push_back({0, 0});
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < 6 * ring; ++i) {
      const double share = static_cast<double>(ring) / rings;
      const Point2 on_circle = share * direction(i, 6 * ring);
      const Point2 on_lattice = share * on_hexagon(i, ring);
      const double blend = share * share;
      mesh.vertices.push_back(radius * ((1 - blend) * on_lattice + blend * on_circle));
    }
  for (int ring = 1; ring <= rings; ++ring)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k < ring; ++k) {
        const int outer = sector * ring + k;
        const int inner = sector * (ring - 1) + k;
        mesh.triangles.push_back(
            {ring_vertex(ring - 1, inner), ring_vertex(ring, outer), ring_vertex(ring, outer + 1)});
        if (k + 1 < ring)
          mesh.triangles.push_back({ring_vertex(ring - 1, inner), ring_vertex(ring, outer + 1),
                                    ring_vertex(ring - 1, inner + 1)});
      }
  return mesh;
}

PlanarMesh grid_mesh(int columns, int rows, double cell) {
  PlanarMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.vertices.push_back({cell * i, cell * j});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      const int b = a + 1;
      const int c = b + columns + 1;
      const int d = c - 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

PlanarMesh jittered(PlanarMesh mesh, double amount) {
  const std::vector<bool> boundary = boundary_vertices(mesh);
  uint32_t state = 12345;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return 2 * (state >> 8) / 16777216.0 - 1;
  };
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point2 move{amount * next(), amount * next()};
    if (!boundary[v]) mesh.vertices[v] = mesh.vertices[v] + move;
  }
  return mesh;
}

std::vector<bool> boundary_vertices(const PlanarMesh& mesh) {
  std::map<std::array<int, 2>, int> uses;
  for (const auto& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k];
      const int b = triangle[(k + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  std::vector<bool> boundary(mesh.vertices.size(), false);
  for (const auto& [edge, count] : uses)
    if (count == 1)
      for (const int v : edge) boundary[v] = true;
  return boundary;
}

}  // namespace relievo::testing
