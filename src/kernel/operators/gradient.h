#pragma once

#include <span>
#include <vector>

#include "kernel/operators/flat_mesh.h"

namespace relievo {

/// Gradient on each triangle of the function with the given nodal values, #F. O(F).
std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values);

/// Gradient at each node, #N: that of a quadratic function through the node's own value, fitted to
/// the values around by least squares. Two rings of neighbours take part on a boundary and where
/// one is too few; where those do not determine it either (slivers, single triangles), the
/// area-weighted mean of the faces around does. Exact for quadratic functions; second order for
/// smooth ones, boundary included. Zero at a node without faces. O(N + F).
std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values);

}  // namespace relievo
