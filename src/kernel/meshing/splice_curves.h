#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/result.h"

namespace relievo {

/// A curve to be put into a planar arrangement.
struct InputCurve {
  Ring points;             ///< at least 3, or 2 of an open one
  std::vector<bool> kept;  ///< per point: a corner or an end that others snap to
};

/// Curves without crossings: two edges meet only at shared vertices or coincide.
struct SplicedCurves {
  std::vector<Point2> points;
  /// Per closed curve the point indices around it; empty where the curve collapsed.
  std::vector<std::vector<int>> loops;
  /// Per open line the point indices along it; likewise.
  std::vector<std::vector<int>> lines;
  /// Per closed curve and input point the index that stands for it.
  std::vector<std::vector<int>> image;
};

/// Bounds of the snapping, as fractions of the shorter of the edges involved.
inline constexpr double snap_to_vertex = 0.15;
inline constexpr double snap_to_edge = 0.1;

/// Splices closed curves and open lines at crossings and contacts. A vertex moves by at most
/// snap_to_vertex of its shorter edge, those of lines rather than those of curves; a curve is bent
/// to a vertex at most snap_to_edge of the shorter edge beside it; but in the
/// end no two vertices are nearer than `grain`, and no vertex and edge than half of it. Fails with
/// bad_input where the curves are too tangled to settle, or limit where they cross too often.
/// Near-linear for edges of similar length.
Result<SplicedCurves> splice_curves(const std::vector<InputCurve>& curves,
                                    const std::vector<InputCurve>& lines = {}, double grain = 0);

}  // namespace relievo
