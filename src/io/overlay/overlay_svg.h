#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relievo/scene.h"
#include "relievo/session.h"

namespace relievo {

/// What else is drawn over a drawing.
struct OverlayMarks {
  std::vector<std::vector<Point2>> bridges;  ///< gaps of lines that were closed, canvas px
  /// Where joins, relations and ranges lie on the mesh, the automatic ones too; in place of what
  /// the scene says of them, if given.
  std::optional<MeshLines> lines;
};

/// An SVG picture of what was understood of a drawing, to be laid over it: parts tinted from blue
/// (back) to yellow (front), completed outlines dashed, joins blue, outlines over other parts
/// cyan (equal), magenta (above) or dark magenta (below), Robin ranges from green to red [P Fig. 3
/// and 5], bridges orange.
/// O(points of overlapping outlines).
std::string overlay_svg(const Scene& scene, const OverlayMarks& marks = {});

}  // namespace relievo
