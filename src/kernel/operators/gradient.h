#pragma once

#include <span>
#include <vector>

#include "kernel/geometry/triangles.h"

namespace relievo {

/// Computes the gradient on each triangle of the piecewise linear function with the given nodal
/// values, #F. O(F).
std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values);

/// The gradient at each node as a linear function of nodal values: at node n the sum of
/// weight (value[neighbour] - value[n]) over the entries begin[n] .. begin[n + 1] - 1.
struct GradientStencils {
  std::vector<size_t> begin;   ///< #N + 1
  std::vector<int> neighbour;  ///< node of each entry
  std::vector<Point2> weight;  ///< of each entry, in 1 / unit of the positions
};

/// Computes stencils for the gradient of a quadratic function that has the node's own value and
/// fits those of its neighbours by weighted least squares. The fit takes one ring of neighbours,
/// and two on a boundary or where one has too few. Where these do not determine the fit (slivers,
/// single triangles), the stencil is the area-weighted mean of the gradients on the faces around.
/// Exact for quadratic functions; second order for smooth ones, boundary included. The stencil of a
/// node without faces is empty. O(N + F).
GradientStencils gradient_stencils(const FlatMesh& mesh);

/// Computes the gradient at each node, #N, in units of the values per unit of the positions.
/// O(entries).
std::vector<Point2> node_gradients(const GradientStencils& stencils,
                                   std::span<const double> values);

/// Computes the gradient at each node with stencils for one use. O(N + F).
std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values);

}  // namespace relievo
