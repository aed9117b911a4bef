#pragma once

#include <vector>

#include "kernel/operators/gradient.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/point.h"

namespace relievo {

/// Gradients at the corners of faces beside creases, from values of nodes on their own side only.
struct CreaseStencils {
  std::vector<Corner> corner;  ///< ascending: at nodes of creases and their neighbours
  std::vector<int> place;      ///< of each of them, its place in `node`
  std::vector<int> node;       ///< of the mesh; one that has two sides occurs for each of them
  GradientStencils gradients;  ///< between places, 1 / px
};

/// Empty where the mesh has no crease. O(F + length of creases).
CreaseStencils crease_stencils(const LayeredMesh& mesh);

/// Gradients at the corners of the stencils, of a function with these values at the nodes.
std::vector<Point2> crease_gradients(const CreaseStencils& stencils,
                                     const std::vector<double>& values);

}  // namespace relievo
