#pragma once

#include <vector>

#include "kernel/image/outlines.h"

namespace relievo {

/// A point on a label's ring where three labels meet, since the label beyond the ring changes.
struct Junction {
  size_t at = 0;        ///< first side of the ring after it
  uint16_t before = 0;  ///< label beyond the ring before it
  uint16_t after = 0;   ///< label beyond the ring after it
  Point2
      in;  ///< direction of the ring before it, px; zero where too few sides have `before` beyond
  Point2 out;  ///< direction of the ring after it, likewise
};

/// Finds the junctions of a ring, in its order. A direction is a chord of up to 11 sides that
/// begins 3 sides from the junction, since the width of drawn lines displaces what is nearer.
/// O(sides + junctions).
std::vector<Junction> find_junctions(const LabelRing& ring);

/// Computes the confidence that the ring's label hides the two others at a T-junction, in [0, 1]:
/// it is larger the straighter the ring runs through the junction, and 0 where a direction is
/// missing.
double t_junction_confidence(const Junction& junction);

}  // namespace relievo
