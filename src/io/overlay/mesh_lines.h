#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo {

/// Where the annotations of a scene lie on its mesh, as segments of edges in canvas px.
struct MeshLines {
  std::vector<float> joins;  ///< #S x 4: x0 y0 x1 y1
  std::vector<float> equal;  ///< likewise: outlines whose height is that of the part behind
  std::vector<float> above;  ///< likewise: outlines held apart from another part, either side
  std::vector<float> below;  ///< likewise: those that are so against the order of parts
  std::vector<float> ramps;  ///< #S x 6: x0 y0 x1 y1, then alpha [P eq 9] at both ends
};

/// `alpha0` is that of the inflation, for ramps that have none of their own. Linear in faces.
MeshLines find_mesh_lines(const LayeredMesh& mesh, double alpha0);

}  // namespace relievo
