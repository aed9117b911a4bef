#pragma once

#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

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

/// A model and the picture that lies on it, which is empty where there is none.
struct DrawnModel {
  Model model;
  Drawing drawing;
};

}  // namespace relievo
