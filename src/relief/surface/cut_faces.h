#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "relief/surface/model_builder.h"
#include "relief/surface/sheet_surface.h"
#include "relievo/result.h"
#include "relievo/run_context.h"

namespace relievo::relief {

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

/// A model vertex on an edge and its place there.
struct EdgePoint {
  int vertex = -1;   ///< index in the model
  double level = 0;  ///< see RimLevels
  double t = 0;      ///< position along the walk over the edge, in [0, 1]
};

/// A surface with its cuts. Model vertices of the surface are its own vertices followed by the
/// cuts, in their order, and those of creases a second time.
struct CutSurface {
  const LayeredMesh& mesh;
  const SheetSurface& sheets;
  const EdgeCuts& cuts;
};

/// Appends the points of an edge, both ends included, in the direction of its face: from the
/// corner after the opposite one onwards, or backwards.
void append_edge_points(const CutSurface& surface, FaceEdge edge, bool backwards,
                        std::vector<EdgePoint>& points);

/// Triangulates the kept faces between their cut edges. The strips between successive levels
/// keep every triangle within the tolerance of the cuts; no vertex is added inside a face. Faces
/// count as hidden where they lie more than `hidden_depth` px below the front one.
Status cut_faces(const CutSurface& surface, double hidden_depth, const RunContext& context,
                 ModelBuilder& builder);

/// Measures inflated heights in steps that a chord may span.
///
/// On a piece where u is linear, the chord of sqrt(u) between heights a and b departs from it by
/// (b - a)^2 / (4 (a + b)) at most. With the level k of a height defined by |f| = 2 tau k (k + 1)
/// and the sign of f, two heights of the same sign whose levels differ by at most 1 depart by at
/// most tau: levels are dense at the outline, as the profile demands, and spread inwards.
/// A triangle on which sqrt(u) is replaced by its linear interpolant departs by no more than its
/// edge with the widest range, so cutting edges is all that is needed.
class RimLevels {
 public:
  /// `tolerance` > 0, px.
  explicit RimLevels(double tolerance);

  /// Level of sgn(u) sqrt|u|; odd and increasing in u. Exactly 0 for heights so small that they
  /// cannot be told from the outline within the tolerance.
  double level(double u) const;

  /// The height f at a level, px.
  double height(double level) const;

 private:
  double tau_;   ///< tolerance less the share that heights near 0 take
  double flat_;  ///< heights up to this count as 0
};

/// Number of points that cut an edge between two levels so that no piece spans more than one
/// level or a change of sign. Capped at a million.
int cut_count(double first, double last);

/// Level of cut i of `cut_count(first, last)`, counted from `first`. Strictly between both ends
/// and monotone in i; a change of sign is cut at exactly 0.
double cut_level(double first, double last, int i);

}  // namespace relievo::relief
