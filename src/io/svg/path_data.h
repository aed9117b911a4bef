#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "io/svg/svg_values.h"
#include "relievo/point.h"

namespace relievo {

enum class SegmentKind { move, line, cubic, close };

/// One absolute step of a path. A close has no `end`; only a cubic has controls.
struct PathSegment {
  SegmentKind kind = SegmentKind::move;
  Point2 control1;
  Point2 control2;
  Point2 end;
};

using PathData = std::vector<PathSegment>;

/// A flattened subpath. Filling closes it anyway; `closed` is for its stroke.
struct Polyline {
  std::vector<Point2> points;
  bool closed = false;
};

/// Reads a `d` attribute. As SVG demands, an error ends the path, and the part before it is kept;
/// `complete`, if given, becomes false. Quadratic curves and arcs become cubics; an arc departs
/// from its ellipse by less than 1e-5 of the larger radius.
PathData parse_path_data(std::string_view text, bool* complete = nullptr);

/// The parameters of an arc command beside its end.
struct ArcShape {
  double rx = 0;
  double ry = 0;
  double rotation = 0;  ///< degrees
  bool large = false;
  bool sweep = false;
};

/// Appends the elliptical arc from `from` to `to` [SVG 1.1, F.6]. Radii that are too small grow; a
/// zero radius gives a line.
void append_arc(PathData& path, Point2 from, const ArcShape& shape, Point2 to);

/// Flattens the path under `transform` to polylines that depart from it by less than `tolerance`
/// (in the units after the transform). A curve becomes at most 200 pieces. The rest of the path is
/// left out once there are more than `max_points`.
std::vector<Polyline> flatten(const PathData& path, const Affine2& transform, double tolerance,
                              size_t max_points);

}  // namespace relievo
