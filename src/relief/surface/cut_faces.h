#pragma once

#include <vector>

#include "relief/surface/model_builder.h"
#include "relief/surface/sheet_surface.h"
#include "relief/surface/surface_sample.h"
#include "relief/surface/visible_sheet.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

/// The points at which the edges of a surface are cut. The cuts of an edge depend only on u at its
/// two ends, so that all faces and walls beside it agree.
struct EdgeCuts {
  std::vector<double> vertex_level;  ///< #V level of the vertex, see rim_level
  std::vector<int> begin;            ///< #E+1 cuts of edge e are [begin[e], begin[e + 1])
  std::vector<double> level;         ///< #C monotone along the edge, from its owner's side
  std::vector<double> t;             ///< #C position on the edge, in [0, 1], increasing
  /// #E index of the first cut of a crease on its other face, counted on from #C; -1 for other
  /// edges.
  std::vector<int> twin;
};

/// Cuts all edges for the tolerance of the options, doubled until no face gets more than
/// 4^max_rim_levels pieces. Fails with limit, before memory is spent, if the surface would get more
/// than 2^24 triangles. O(edges + cuts).
Result<EdgeCuts> cut_edges(const SheetSurface& surface, const Inflation& inflation,
                           const ModelOptions& options);

/// A surface with its cuts. Its model vertices are, in this order, its own vertices, the cuts, and
/// the cuts of creases a second time.
struct CutSurface {
  const SolvedSurface& solved;
  const SheetSurface& sheets;
  const EdgeCuts& cuts;
};

/// Appends the points of an edge, both ends included, in the direction of its face: from the corner
/// after the opposite one onwards, or backwards.
void append_edge_points(const CutSurface& surface, FaceEdge edge, bool backwards,
                        std::vector<EdgePoint>& points);

/// Triangulates the kept faces between their cut edges. The strips between successive levels
/// keep every triangle within the tolerance of the cuts; no vertex is added inside a face. Faces
/// count as hidden if they lie more than `hidden_depth` px below the front one.
Status cut_faces(const CutSurface& surface, double hidden_depth, const RunContext& context,
                 ModelBuilder& builder);

/// Returns the level of a height f = sgn(u) sqrt|u|: heights measured in steps that a chord may
/// span. Odd and increasing in u, and exactly 0 for heights that cannot be distinguished from the
/// outline within the tolerance (px, > 0).
///
/// On a piece where u is linear, the chord of sqrt(u) between heights a and b departs from it by
/// (b - a)^2 / (4 (a + b)) at most. With the level k of a height defined by |f| = 2 tau k (k + 1)
/// and the sign of f, two heights of the same sign whose levels differ by at most 1 depart by at
/// most tau: levels are dense at the outline, as the profile demands, and spread inwards.
/// A triangle on which sqrt(u) is replaced by its linear interpolant departs by no more than its
/// edge with the widest range, so that it suffices to cut edges.
double rim_level(double u, double tolerance);

/// Returns the height f at a level, px.
double rim_height(double level, double tolerance);

/// Returns the number of points that cut an edge between two levels so that no piece spans more
/// than one level or a change of sign, a million at most.
int cut_count(double first, double last);

/// Returns the level of cut i of `cut_count(first, last)`, counted from `first`: strictly between
/// both ends and monotone in i. A change of sign is cut at exactly 0.
double cut_level(double first, double last, int i);

}  // namespace relievo::relief
