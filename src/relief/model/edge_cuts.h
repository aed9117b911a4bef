#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/model/assemble_model.h"
#include "relief/model/sheet_surface.h"
#include "relievo/result.h"

namespace relievo {

/// Where the edges of a surface are cut. The cuts of an edge depend on u at its two ends only, so
/// all faces and walls beside it agree.
struct EdgeCuts {
  std::vector<double> vertex_level;  ///< #V level of the vertex, see RimLevels
  std::vector<int> begin;            ///< #E+1 cuts of edge e are [begin[e], begin[e + 1])
  std::vector<double> level;         ///< #C monotone along the edge, from its owner's side
  std::vector<double> t;             ///< #C position on the edge, in [0, 1], increasing
  /// #E where the edge is a crease, the number of its first cut as the other face has it: counted
  /// on from #C; -1 elsewhere.
  std::vector<int> twin;
};

/// Cuts all edges for the tolerance of the options, or for the smallest power of two times it
/// with which no face gets more than 4^max_rim_levels pieces. Fails with limit, before memory is
/// spent, where the surface would get more than 2^24 triangles. O(edges + cuts).
Result<EdgeCuts> cut_edges(const SheetSurface& surface, const Inflation& inflation,
                           const ModelOptions& options);

}  // namespace relievo
