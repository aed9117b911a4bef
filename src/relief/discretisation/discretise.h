#pragma once

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/run_context.h"

namespace relievo {

/// Assembles the operators of the joined surface and orders its nodes for elimination. Reads the
/// triangulation, the nodes and the flaps of the mesh, not its roles nor the constraints. Where
/// `context` is cancelled the result is of no use. O(N log N).
Discretisation discretise(const LayeredMesh& mesh, const RunContext& context = {});

}  // namespace relievo
