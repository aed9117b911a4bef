#pragma once

#include "relief/model/cut_faces.h"

namespace relievo {

/// Closes the open edges of a surface whose vertices and cuts are already in the builder.
///
/// Heights beside an open edge that differ by no more than `weld_tolerance` (px) are made equal;
/// where the two copies of an edge then coincide, nothing else is needed. Otherwise a vertical
/// wall of the higher part joins them. It uses the points of both copies and, where more than two
/// surfaces meet over a base vertex, the points of all of them: after vertices at one place are
/// merged, no edge is left open between two triangles. O(w log w) for w open edges.
void close_open_edges(const CutSurface& surface, double weld_tolerance, ModelBuilder& builder);

}  // namespace relievo
