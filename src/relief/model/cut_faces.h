#pragma once

#include <vector>

#include "relief/model/edge_cuts.h"
#include "relief/model/model_builder.h"
#include "relief/model/sheet_surface.h"

namespace relievo {

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

}  // namespace relievo
