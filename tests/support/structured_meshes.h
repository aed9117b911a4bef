#pragma once

#include <array>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relievo/point.h"

namespace relievo::testing {

struct PlanarMesh {
  std::vector<Point2> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< positive area, y down

  FlatMesh flat() const { return {vertices, triangles}; }
};

/// A disc of `rings` concentric rings around the origin, ring k with 6 k vertices; the vertices of
/// the outermost lie on the circle and are the last ones. Towards the centre the rings become
/// hexagons, so that refinement leaves no vertex where the mesh is not locally a lattice.
PlanarMesh disc_mesh(double radius, int rings);

/// columns x rows cells of the given size from the origin, all cut along the same diagonal, so that
/// every inner vertex is alike. Vertex (i, j) has index j * (columns + 1) + i.
PlanarMesh grid_mesh(int columns, int rows, double cell);

/// Moves vertices that are not on the boundary by up to `amount` in each axis, always alike.
PlanarMesh jittered(PlanarMesh mesh, double amount);

/// Which vertices are on the boundary.
std::vector<bool> boundary_vertices(const PlanarMesh& mesh);

}  // namespace relievo::testing
