#pragma once

#include <array>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relievo/point.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The gradient v that parts with a lean, slopes or creases want of their shift g: the ordering
/// minimises the integral of |grad g - v|^2, which changes grad f in [P eq 10] as [P §5] suggests.
struct SlopeField {
  /// #F, v: how much nearer to the viewer the surface comes per px to the right and downwards.
  std::vector<Point2> slope;
  /// #F, at the corners of each face, in units of the positions: the function on the part with the
  /// gradient nearest to v. Its constant has no meaning.
  std::vector<std::array<double, 3>> rise;
};

/// Returns whether a part of the scene has a lean, a slope or a crease.
bool has_slopes(const Scene& scene);

/// Computes v = lean + w on each part. Slopes and creases give w, after the slope cues of Yeh et
/// al. 2017. It is harmonic in the part (and may jump across creases) with
///   w = tan(angle) t   on the line of a slope, with its unit direction t,
///   w = tan(angle) n   on both sides of a crease, with the unit normal n towards it,
///   w = 0              where the part is joined to another: the surface stays smooth there,
///   dw/dn = 0          on the rest of the outline.
/// A vertex that several cues meet gets the mean of its creases, or of its slopes if it has no
/// crease. `scale` is that of positions in the rise, per px. Two factorisations for each part with
/// cues.
SlopeField slope_field(const LayeredMesh& mesh, const Scene& scene, double scale);

/// Computes the factor of each face's source in the inflation, #F: the mean of b^2 over the face,
/// so that L f~ = M c [P eq 7] becomes L f~ = M (c b^2). On each part b is harmonic; it is the
/// value of a bulge along its stroke and 1 on the outline, joined or not [P §5, after the curvature
/// cues of Yeh et al. 2017]. A vertex that several strokes meet gets the mean of their values.
/// Empty if the scene has no bulge. One factorisation for each part with bulges.
std::vector<double> bulge_factors(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo::relief
