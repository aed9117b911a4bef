#pragma once

#include "relief/layers/layered_mesh.h"
#include "relievo/session.h"

namespace relievo {

/// `alpha0` is that of the inflation, for ramps that have none of their own. Linear in faces.
MeshLines find_mesh_lines(const relief::LayeredMesh& mesh, double alpha0);

}  // namespace relievo
