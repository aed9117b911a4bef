#pragma once

#include <array>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// What the shift of each part would be like if nothing held it [P eq 10, §5].
struct SlopeField {
  /// #F, v: how much nearer the surface comes per px to the right and downwards.
  std::vector<Point2> slope;
  /// #F, at the corners of each face, in units of the positions: the function of the part whose
  /// gradient is nearest to v. Its constant is of no meaning.
  std::vector<std::array<double, 3>> rise;
};

/// Whether a part of the scene leans or has a slope or crease.
bool has_slopes(const Scene& scene);

/// v is the lean of the part and what its cues add, after the slope cues of Yeh et al. 2017: a
/// field that is harmonic in the part, tan(angle) along the direction of each slope's line on that
/// line, and tan(angle) towards each crease on both of its sides, across which it jumps. It has no
/// flow through the outline, and is 0 where the part is joined to another, so that the surface
/// stays smooth there. Where several cues meet a vertex, creases count more than slopes, and the
/// mean of alike ones. `scale`: of positions in the rise, per px. Two factorisations for each part
/// with cues.
SlopeField slope_field(const LayeredMesh& mesh, const Scene& scene, double scale);

/// The factor by which bulges change the source of the inflation, #F: the mean of b^2 over each
/// face. On each part b is harmonic, the value of a bulge along its stroke and 1 on the outline,
/// joined or not [P §5, after the curvature cues of Yeh et al. 2017]. Empty where the scene has no
/// bulge. Where strokes with different values meet a vertex it has their mean. A factorisation for
/// each part with one.
std::vector<double> bulge_factors(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo::relief
