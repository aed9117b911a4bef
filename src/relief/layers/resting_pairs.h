#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo {

/// Pairs of nodes inside two parts of which the front one is seen and may rest on the other, the
/// next below out of which it does not grow: a flat patch on a round belly. None where the front
/// part has d < 0 or a relation "free" without a range lets it pass. Sorted, each once. O(F log F).
std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo
