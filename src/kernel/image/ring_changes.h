#pragma once

#include <vector>

#include "kernel/image/outlines.h"

namespace relievo {

/// A point where three labels meet: the label beyond a label's ring changes.
struct RingChange {
  size_t at = 0;          ///< the first side after the change
  uint16_t before = 0;    ///< label beyond the ring before the change
  uint16_t after = 0;     ///< label beyond the ring after it
  size_t run_before = 0;  ///< pixel sides with label `before` beyond, at most `far`
  size_t run_after = 0;   ///< pixel sides with label `after` beyond, at most `far`
  Point2 in;              ///< chord of the ring before the change, px; zero where its run is short
  Point2 out;             ///< chord of the ring after the change, likewise
};

/// Lists all changes of a ring, in its order. The chords extend from `near` to `far` sides from the
/// change: the width of drawn lines displaces nearer sides. They are zero for runs of at most
/// `near` + 1 sides. O(sides * far).
std::vector<RingChange> ring_changes(const LabelRing& ring, size_t near, size_t far);

}  // namespace relievo
