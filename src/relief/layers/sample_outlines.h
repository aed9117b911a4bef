#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/size_field.h"
#include "kernel/meshing/splice_curves.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// A run of samples of one curve, in the curve's direction, from `first` to `last`.
struct CurveRun {
  int curve = -1;
  int first = 0;
  int last = 0;
  double length = 0;      ///< px
  bool reversed = false;  ///< the user's first point is at `last`
};

/// All outlines, resampled.
struct SampledOutlines {
  std::vector<InputCurve> curves;         ///< one per ring of every part
  std::vector<int> curve_part;            ///< per curve
  std::vector<CurveSample> samples;       ///< all samples of all curves, in order
  std::vector<CurveRun> joins;            ///< per join of the scene
  std::vector<CurveRun> robin;            ///< per Robin range of the scene
  std::vector<CurveRun> relation_ranges;  ///< per relation; curve -1 where it has no range
  std::vector<InputCurve> creases;        ///< open lines
  std::vector<int> crease_cue;            ///< per such line, its cue of the scene
  double detail =
      0;  ///< px; what is far smaller is lost: the spacing, or less where that is coarse
  std::vector<std::string> warnings;
};

/// Resamples every outline, and every crease, at about `spacing` px, finer where an outline bends,
/// keeping corners and the ends of joins and ranges. Rings that are specks have no samples, with a
/// warning that names their part. Fails with bad_input naming the part, join or range, or where
/// there are only specks. O(outline points * (1 + marks of the part)).
Result<SampledOutlines> sample_outlines(const Scene& scene, double spacing);

}  // namespace relievo::relief
