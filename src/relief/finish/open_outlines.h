#pragma once

#include <vector>

#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A chain of edges along the outline of a part.
struct OpenOutline {
  int part = 0;
  bool closed = false;
  std::vector<int> vertices;  ///< of the model; the part lies on the left, seen from the front
  std::vector<Point2> out;    ///< by vertex, unit, out of the part in the plane, y up
};

/// Returns the outlines of a model, by part: the edges with one triangle, and those where a part
/// borders on one behind it, as at joins. `out` is zero where no direction leads out of the part.
/// O(n log n) for n triangles.
std::vector<OpenOutline> open_outlines(const Model& model);

}  // namespace relievo::relief
