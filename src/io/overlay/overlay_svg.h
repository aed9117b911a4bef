#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relievo/scene.h"
#include "relievo/session.h"

namespace relievo {

/// Further lines of an overlay.
struct OverlayMarks {
  std::vector<std::vector<Point2>> bridges;  ///< gaps of lines that were closed, canvas px
  /// Joins, relations and ranges on the mesh, with the automatic ones; painted in place of those of
  /// the scene, if given.
  std::optional<MeshLines> lines;
};

/// Returns an SVG picture of a scene to lay over its drawing: parts tinted from blue (back) to
/// yellow (front), completed outlines dashed, joins blue, outlines over other parts cyan (equal),
/// magenta (above) or dark magenta (below), Robin ranges from green to red [P Fig. 3 and 5],
/// bridges orange. O(points of overlapping outlines).
std::string overlay_svg(const Scene& scene, const OverlayMarks& marks = {});

}  // namespace relievo
