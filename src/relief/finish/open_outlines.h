#pragma once

#include <vector>

#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A chain of edges at which the surface of a part is open.
struct OpenOutline {
  int part = 0;
  bool closed = false;
  std::vector<int> vertices;  ///< of the model; the part lies on the left, seen from the front
  std::vector<Point2> out;    ///< by vertex, unit, out of the part in the plane, y up
};

/// Returns the chains along which a model is open, by part: the edges with one triangle. Zero where
/// no direction leads out. O(n log n) for n triangles.
std::vector<OpenOutline> open_outlines(const Model& model);

}  // namespace relievo::relief
