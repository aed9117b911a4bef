#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/sample_outlines.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Resamples the creases of the scene at about `spacing` px, keeping their corners: where they lie
/// in their part, and half a spacing beyond its outline where they cross it. One that all but
/// reaches the outline is drawn on to it. Appends them to the creases and samples of `sampled`.
/// O(points of creases * points of their parts' outlines).
void sample_creases(const Scene& scene, double spacing, SampledOutlines& sampled);

/// The edges of the sheets along `lines`, polylines of base vertices, inside the part that each
/// belongs to. `lines[i]` is of cue `cue[i]`. O(edges + height of the stacks).
std::vector<CreaseEdge> find_creases(const SheetMesh& mesh,
                                     const std::vector<std::vector<int>>& lines,
                                     const std::vector<int>& cue, const Scene& scene);

}  // namespace relievo::relief
