#pragma once

#include <string>
#include <vector>

#include "relievo/model.h"

namespace relievo::relief {

/// A vertex of a visible sheet on an edge of the base triangulation.
struct StepPoint {
  int vertex = -1;
  double t = 0;  ///< position along the edge, in [0, 1]
};

/// An edge along which the surface may change its depth: the vertices on it as each of the two
/// faces beside it has them, from one common end to the other. Their places agree at both ends
/// only.
struct SheetStep {
  std::vector<StepPoint> first;
  std::vector<StepPoint> second;
};

/// The rearmost of all parts at a place, each as deep behind its own shift surface as it is high in
/// front of it.
struct BackPoint {
  double z = 0;  ///< px, g - |f|
  int part = 0;
};

/// What the front shows, as a function of x and y: the triangles of a relief without its walls.
struct VisibleSheet {
  Model model;                   ///< all of its triangles face the viewer
  std::vector<SheetStep> steps;  ///< where walls would stand, by base triangle
  std::vector<BackPoint> back;   ///< behind every vertex, a function of its place
};

/// A limb by itself, with what grows out of it and lies on it, as it would be if the part that it
/// grows out of were not there. Mirrored about `middle` it is the limb of the far side; its root is
/// drawn in so that it then ends inside of that part.
struct LimbSheet {
  std::string id;     ///< of the part
  double middle = 0;  ///< px, where the part that it grows out of is neither in front nor behind
  VisibleSheet sheet;
};

}  // namespace relievo::relief
