#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo {

/// The factor by which bulges change the source of the inflation, #F: the mean of b^2 over each
/// face. On each part b is harmonic, the value of a bulge along its stroke and 1 on the outline,
/// joined or not [P §5, after the curvature cues of Yeh et al. 2017]. Empty where the scene has no
/// bulge. Where strokes with different values meet a vertex it has their mean. A factorisation for
/// each part with one.
std::vector<double> bulge_factors(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo
