#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The boundary conditions of the joined sheets, as in LayeredMesh, and what follows from them.
struct Boundaries {
  std::vector<NodeRole> role;  ///< #N
  std::vector<RobinRamp> ramps;
  std::vector<RampNode> ramp_nodes;
  std::vector<BumpNode> bump_nodes;
  std::vector<DepthPair> glued;  ///< pairs within ranges beside joins, which stay together
};

/// Finds the role of every node and lays the Robin ranges, `robin_runs` being those of the scene.
/// From each merged end of a join one runs along the upper outline to its exit, where that outline
/// meets the rim of the lower surface, or for the length of the join if there is no exit. Beside
/// the join of a bump one runs each way for the length of the join, or half of the way to the next
/// join. Ranges of the scene replace those that they touch. If `attach`, nodes within ranges refer
/// to the nodes below them. O(F * height of the stacks + length of the outlines * runs).
Boundaries find_boundaries(const SheetMesh& mesh, const Scene& scene,
                           const std::vector<LoopRun>& robin_runs, bool attach);

/// Finds the faces behind parts that grow out of their surface, #F: from the covered side of each
/// join as far as the upper part covers the surface. They are `loose`, or `kept` if `loose` is
/// false, if d changes its sign on the surface, or if the rest of the surface would have no
/// outline. `role` is that of each node. O((F + faces of the flaps) * height of the stacks).
std::vector<Flap> find_flaps(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                             const LocalOrder& order, const Scene& scene, bool loose);

}  // namespace relievo::relief
