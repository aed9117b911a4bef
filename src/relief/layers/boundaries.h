#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/sample_outlines.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A run of base vertices along one loop.
struct LoopRun {
  int loop = -1;
  int position = 0;  ///< of its first vertex in the loop
  int edges = 0;
  bool reversed = false;  ///< the user's first point is its last vertex
};

/// A pair of nodes beside a join that stay together.
struct GluedPair {
  int lower = -1;
  int upper = -1;
};

/// What bounds the joined sheets.
struct Boundaries {
  std::vector<NodeRole> role;  ///< #N
  std::vector<RobinRamp> ramps;
  std::vector<RampNode> ramp_nodes;
  std::vector<GluedPair> glued;
  std::vector<BumpNode> bump_nodes;
};

/// Finds the role of every node and lays the Robin ranges: from each merged end of a seam along
/// the upper outline to its exit, where that outline meets the rim of the lower surface, or for
/// the length of the seam where there is no exit; and the ranges given by the scene, which
/// replace automatic ones that they touch. Where `attach`, their nodes name those below them.
/// Near-linear in the length of the outlines.
Boundaries find_boundaries(const SheetMesh& mesh, const Scene& scene,
                           const std::vector<LoopRun>& robin_runs, bool attach);

/// The outlines of all bumps. Beside a join they come loose for its length, or half of the way to
/// the next one; ranges of the scene replace those that they touch. Adds these ranges to `ramps`.
/// Near-linear in the length of the outlines.
std::vector<BumpNode> find_bump_outlines(const SheetMesh& mesh, const Scene& scene,
                                         const std::vector<LoopRun>& robin_runs,
                                         std::vector<RobinRamp>& ramps);

}  // namespace relievo::relief
