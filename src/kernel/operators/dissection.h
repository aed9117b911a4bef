#pragma once

#include <span>
#include <vector>

#include "kernel/geometry/triangles.h"
#include "relievo/run_context.h"

namespace relievo {

/// Computes an elimination order of the vertices of a planar triangulation that keeps the fill-in
/// of Cholesky factors low: geometric nested dissection [George 1973]. A straight cut divides the
/// vertices; the vertices beside it that separate both sides come last in the order, and each side
/// is divided in the same way. Of the cuts at many positions in four directions it takes the one
/// with the lightest separator, with a penalty for imbalance. `weights`, #V: number of unknowns at
/// each vertex. An order of unknowns at the vertices that are coupled along edges follows from it.
/// Returns any order where `context` is cancelled. O(V log V) where the spacing of the vertices
/// varies by bounded factors.
std::vector<int> dissection_order(const FlatMesh& mesh, std::span<const int> weights,
                                  const RunContext& context = {});

}  // namespace relievo
