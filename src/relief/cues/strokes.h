#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/cues/part_sheet.h"
#include "relievo/scene.h"

namespace relievo {

/// A triangle of a sheet that a segment of a cue's line meets.
struct StrokeContact {
  int triangle = -1;  ///< of the sheet
  const Cue* cue = nullptr;
  Point2 along;  ///< unit direction of the segment
};

/// All triangles that lines of the scene's cues of a kind on `part` meet. `scale`: that of the
/// sheet. O(K * points of the lines).
std::vector<StrokeContact> stroke_contacts(const PartSheet& sheet, const Scene& scene, int part,
                                           CueKind kind, double scale);

/// Which parts have a cue of one of the kinds, #parts.
std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds);

}  // namespace relievo
