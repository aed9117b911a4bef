#pragma once

#include <optional>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/result.h"

namespace relievo {

/// A curve of a planar arrangement.
struct InputCurve {
  Ring points;             ///< at least 3, or 2 of an open line
  std::vector<bool> kept;  ///< per point: whether it is a corner or an end to which others snap
};

/// Curves without crossings: two edges coincide, or meet only at shared vertices.
struct SplicedCurves {
  std::vector<Point2> points;
  /// Point indices around each closed curve; empty where the curve collapsed.
  std::vector<std::vector<int>> loops;
  /// Point indices along each open line; empty where the line collapsed.
  std::vector<std::vector<int>> lines;
  /// For each point of each closed curve the index of the point that replaces it.
  std::vector<std::vector<int>> image;
};

/// Bounds of the snapping over the length of the shortest edge involved.
inline constexpr double snap_to_vertex = 0.15;
inline constexpr double snap_to_edge = 0.1;

/// Splices closed curves and open lines at crossings and contacts. A vertex moves by at most
/// snap_to_vertex of its shorter edge, vertices of lines before those of curves. A curve bends to a
/// vertex by at most snap_to_edge of the shorter edge involved. In the end no two vertices are
/// nearer than `grain`, and no vertex is nearer to an edge than half of it; for that both may move
/// farther. Fails with bad_input where the curves are too tangled to settle, and with limit where
/// they cross too often. Near-linear for edges of similar length.
Result<SplicedCurves> splice_curves(const std::vector<InputCurve>& curves,
                                    const std::vector<InputCurve>& lines = {}, double grain = 0);

/// Finds the first point along an outline where two of its edges cross; nothing where all rings are
/// simple and meet each other at corners at most. The test is exact, the point is rounded.
/// Near-linear for edges of similar length.
std::optional<Point2> find_self_crossing(const Outline& outline);

}  // namespace relievo
