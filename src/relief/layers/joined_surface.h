#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relievo/point.h"

namespace relievo {

/// Whether a node with this role lies within a surface, joins included.
inline bool is_inside(NodeRole role) {
  return role == NodeRole::interior || role == NodeRole::seam;
}

/// Scene units per px: multiplied by it, the box around all faces has a diagonal of 2. This gives
/// the Robin coefficient and epsilon, which have units of length, the same meaning at any size.
/// 1 where there is no face. O(F).
double scene_scale(const LayeredMesh& mesh);

/// Where each node lies, canvas px times `scale`, #N. With the faces it is the flat joined mesh.
std::vector<Point2> node_positions(const LayeredMesh& mesh, double scale = 1);

/// Whether each node is at a face that is in front of all others, #N. O(T + N).
std::vector<uint8_t> seen_nodes(const LayeredMesh& mesh);

/// The faces that shape the surface: all but flaps. O(F).
std::vector<std::array<int, 3>> shaping_faces(const LayeredMesh& mesh);

/// The joined surface of each node, #N, named by its smallest node. Near-linear.
std::vector<int> joined_surfaces(const LayeredMesh& mesh);

}  // namespace relievo
