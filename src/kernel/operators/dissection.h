#pragma once

#include <span>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relievo/run_context.h"

namespace relievo {

/// An order of the vertices of a planar triangulation in which matrices on it fill in little:
/// nested dissection [George 1973]. A straight cut parts the vertices, those beside it that
/// separate the sides come last, and each side is parted in the same way. Of the cuts at many
/// places in four directions the one with the lightest separator is taken, unbalanced ones at a
/// premium. `weights`, #V: unknowns at each vertex. An order for unknowns that lie at the vertices
/// and are coupled along the edges follows from it, whatever else couples them.
/// Where `context` is cancelled it is any order. O(V log V) where the spacing of the vertices
/// varies by bounded factors.
std::vector<int> dissection_order(const FlatMesh& mesh, std::span<const int> weights,
                                  const RunContext& context = {});

}  // namespace relievo
