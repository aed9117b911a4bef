#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/ordering/ordering.h"
#include "relief/surface/cut_faces.h"
#include "relief/surface/visible_sheet.h"

namespace relievo::relief {

/// Closes the open edges of a surface whose vertices and cuts are already in the builder.
///
/// Heights beside an open edge that differ by no more than `weld_tolerance` (px) are made equal;
/// where the two copies of an edge then coincide, nothing else is needed. Otherwise a vertical
/// wall of the higher part joins them. It uses the points of both copies and, where more than two
/// surfaces meet over a base vertex, the points of all of them: after vertices at one place are
/// merged, no edge is left open between two triangles. O(w log w) for w open edges.
void close_open_edges(const CutSurface& surface, double weld_tolerance, ModelBuilder& builder);

/// What lies behind the vertices of a cut surface, its cuts included, all sheets counted but
/// hollows: of the part with the least g - |f|, the first of several.
/// O(faces + cuts * height of a stack).
std::vector<BackPoint> back_points(const CutSurface& surface, const Inflation& inflation,
                                   const Ordering& ordering);

}  // namespace relievo::relief
