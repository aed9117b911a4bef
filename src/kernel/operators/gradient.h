#pragma once

#include <span>
#include <vector>

#include "kernel/geometry/triangles.h"

namespace relievo {

/// Gradient on each triangle of the function with the given nodal values, #F. O(F).
std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values);

/// The gradient at each node as a linear function of the values around: at node n the sum of
/// weight (value[neighbour] - value[n]) over entries begin[n] .. begin[n + 1] - 1.
struct GradientStencils {
  std::vector<size_t> begin;  ///< #N + 1
  std::vector<int> neighbour;
  std::vector<Point2> weight;  ///< 1 / unit of the positions
};

/// That of a quadratic function through the node's own value, fitted to the values around by least
/// squares. Two rings of neighbours take part on a boundary and where one is too few; where those
/// do not determine it either (slivers, single triangles), the area-weighted mean of the faces
/// around does. Exact for quadratic functions; second order for smooth ones, boundary included.
/// Zero at a node without faces. O(N + F).
GradientStencils gradient_stencils(const FlatMesh& mesh);

/// Gradient at each node, #N, in units of the values per unit of the positions. O(entries).
std::vector<Point2> node_gradients(const GradientStencils& stencils,
                                   std::span<const double> values);

/// The same with stencils for one use. O(N + F).
std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values);

}  // namespace relievo
