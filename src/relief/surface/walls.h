#pragma once

#include <vector>

#include "relief/surface/cut_faces.h"
#include "relief/surface/visible_sheet.h"

namespace relievo::relief {

/// Closes the open edges of a surface whose vertices and cuts are already in the builder.
///
/// Heights beside an open edge that differ by no more than `weld_tolerance` (px) are made equal.
/// If the two copies of an edge then coincide, it is closed. Otherwise a vertical wall of the
/// higher part joins them. The wall uses the points of both copies and, if more than two surfaces
/// meet over a base vertex, the points of all of them: after vertices at one position are merged,
/// no edge is open between two triangles. O(w log w) for w open edges.
void close_open_edges(const CutSurface& surface, double weld_tolerance, ModelBuilder& builder);

/// Returns the points behind the vertices of a cut surface and its cuts: of all sheets but hollows
/// and those of parts that do not reach the silhouette, the one with the least g - |f|, the first
/// of several. O(faces + cuts * height of a stack).
std::vector<BackPoint> back_points(const CutSurface& surface);

}  // namespace relievo::relief
