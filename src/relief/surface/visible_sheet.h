#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"

namespace relievo::relief {

/// A model vertex on an edge of the base triangulation.
struct EdgePoint {
  int vertex = -1;   ///< index in the model
  double level = 0;  ///< see rim_level
  double t = 0;      ///< position along the walk over the edge, in [0, 1]
};

/// An edge at which the depth of the surface may jump: the vertices on it as each of the two faces
/// beside it has them, from one common end to the other. Only at both ends do their positions
/// agree.
struct SheetStep {
  std::vector<EdgePoint> first;
  std::vector<EdgePoint> second;
};

/// The rearmost part over a point of the canvas. Each part is as deep behind its own shift surface
/// as it is high in front of it. Parts that do not reach the silhouette, such as eyes, have no
/// back.
struct BackPoint {
  double z = 0;  ///< px, g - |f|
  int part = 0;
};

/// The surface seen from the front, as a function of x and y: a relief without its walls.
struct VisibleSheet {
  Model model;                   ///< all of its triangles face the viewer
  std::vector<SheetStep> steps;  ///< the edges where walls would stand, by base triangle
  std::vector<BackPoint> back;   ///< behind every vertex, a function of its position
};

/// A limb on its own, with everything that grows out of it or lies on it, as if its trunk, the part
/// that it grows out of, were not there. Mirrored about `middle` it is the limb of the far side;
/// its root is drawn in, so that the mirrored root ends inside the trunk.
struct LimbSheet {
  std::string id;     ///< of the part
  double middle = 0;  ///< px, the depth of the trunk's shift surface at the join
  VisibleSheet sheet;
};

}  // namespace relievo::relief
