#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "relievo/model.h"
#include "relievo/point.h"

namespace relievo::relief {

/// A vertex on the seen outline of a part. Lengths are in canvas px; y points up.
struct OutlinePoint {
  int vertex = -1;     ///< of the model
  Point2 place;        ///< of the vertex
  Point2 out;          ///< unit, out of the part
  double inside = 0;   ///< distance from the outline to the ink's inner edge
  double outside = 0;  ///< distance to its outer edge, over what lies behind
  double room = 0;     ///< half the breadth of the part here, as far as it was measured
};

/// A run of a part's seen outline that is inked.
struct InkLine {
  int part = 0;
  bool closed = false;
  std::vector<OutlinePoint> points;  ///< the part lies on the left
};

/// The usual ink of a part.
struct PartInk {
  double width = 0;  ///< canvas px; 0 if its outline is not inked
  std::array<uint8_t, 3> rgb{};
};

/// The contours of a drawing: the ink along the outlines of parts.
struct ContourInk {
  std::vector<InkLine> lines;       ///< by part
  std::vector<OutlinePoint> plain;  ///< the seen outlines without ink
  std::vector<PartInk> parts;       ///< by part of the model
};

/// Measures the ink along the seen outlines of a surface that lies on a drawing: dark runs across
/// the outline with lighter paint inside them. A part counts as inked if half of its seen outline
/// is, or three quarters where widths vary. There is no ink on pixel art. Linear in pixels and in
/// outlines times the width of ink.
ContourInk find_ink(const Model& model, const Drawing& drawing);

}  // namespace relievo::relief
