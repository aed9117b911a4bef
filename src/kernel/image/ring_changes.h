#pragma once

#include <vector>

#include "kernel/image/outlines.h"

namespace relievo {

/// A place where three labels meet: a label's ring goes on along another one.
struct RingChange {
  size_t at = 0;          ///< the first side of what comes after
  uint16_t before = 0;    ///< the label beyond the ring until there
  uint16_t after = 0;     ///< and from there on
  size_t run_before = 0;  ///< pixel sides with that label beyond, as far as it was asked for
  size_t run_after = 0;
  Point2 in;   ///< the way of the ring as it arrives, px; zero where the run is too short
  Point2 out;  ///< and as it leaves
};

/// All changes of a ring, in its order. Directions are those of chords from `near` sides beside the
/// change, since the width of drawn lines displaces what is nearer, to `far`; they are told of runs
/// of more than `near` + 1 sides. O(sides * far).
std::vector<RingChange> ring_changes(const LabelRing& ring, size_t near, size_t far);

}  // namespace relievo
