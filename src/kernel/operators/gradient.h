#pragma once

#include <span>
#include <vector>

#include "kernel/operators/flat_mesh.h"

namespace relievo {

/// Gradient on each triangle of the function with the given nodal values, #F. O(F).
std::vector<Point2> face_gradients(const FlatMesh& mesh, std::span<const double> values);

/// Gradient at each node, #N: a linear function fitted to the gradients of the faces around, each
/// at its centroid and weighted by its area, and taken at the node. Inside, the faces of the node
/// take part; on a boundary also those of its neighbours, for the value is extrapolated there.
/// Exact for linear functions; second order for smooth ones, boundary included. O(N + F).
std::vector<Point2> node_gradients(const FlatMesh& mesh, std::span<const double> values);

}  // namespace relievo
