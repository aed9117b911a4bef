#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/layers/sample_outlines.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Resamples the creases of the scene at about `spacing` px and appends them to the creases and
/// samples of `sampled`. Sharp turns stay. Only the stretches in a crease's part are sampled, with
/// half a spacing beyond its outline where they cross it. A crease that all but reaches the outline
/// is extended to it. O(points of creases * points of their parts' outlines).
void sample_creases(const Scene& scene, double spacing, SampledOutlines& sampled);

/// Finds the edges along `lines`, polylines of base vertices, on the sheets of the parts that they
/// belong to; `cues` has the cue of each line. O(edges * height of the stacks).
std::vector<CreaseEdge> find_creases(const SheetMesh& mesh,
                                     const std::vector<std::vector<int>>& lines,
                                     const std::vector<int>& cues, const Scene& scene);

}  // namespace relievo::relief
