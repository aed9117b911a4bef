#pragma once

#include "relief/layers/layered_mesh.h"
#include "relievo/session.h"

namespace relievo {

/// Returns the segments of the mesh that lie on joins, relations and Robin ranges. `alpha0` of the
/// inflation serves ramps without one of their own. O(faces log faces).
MeshLines find_mesh_lines(const relief::LayeredMesh& mesh, double alpha0);

}  // namespace relievo
