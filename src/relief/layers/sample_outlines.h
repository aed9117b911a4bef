#pragma once

#include <vector>

#include "kernel/meshing/size_field.h"
#include "kernel/meshing/splice_curves.h"
#include "relief/layers/mark_outlines.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// All outlines, resampled.
struct SampledOutlines {
  MarkedOutlines marked;             ///< with the samples of its runs
  std::vector<InputCurve> curves;    ///< one per ring, empty for specks
  std::vector<CurveSample> samples;  ///< all samples of all curves, in order
  std::vector<InputCurve> creases;   ///< open lines
  std::vector<int> crease_cue;       ///< per such line, its cue of the scene
};

/// Resamples every outline, and every crease, at about `spacing` px, finer where an outline bends
/// and at joins. Corners and the ends of joins and ranges stay. Fails with bad_input as
/// mark_outlines does, and if there are only specks. O(outline points * (1 + marks of the part)).
Result<SampledOutlines> sample_outlines(const Scene& scene, double spacing);

}  // namespace relievo::relief
