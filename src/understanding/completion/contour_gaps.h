#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/geometry/polyline.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {

/// A run of a ring that another part may hide, so that the part's own contour is not known there.
struct ContourGap {
  size_t first = 0;    ///< index of its first side in the ring
  size_t count = 0;    ///< number of sides
  DirectedPoint from;  ///< where the known contour ends, and its direction there
  DirectedPoint to;    ///< where it goes on
};

/// How much of a ring is known.
struct KnownContour {
  std::vector<ContourGap> gaps;  ///< in the order of the ring
  bool nothing = false;          ///< the whole ring may be hidden
  std::vector<uint8_t> hidden;   ///< per side, 1 in a gap
};

/// Sides next to a junction of three labels are displaced by the width of the lines there and are
/// not used.
constexpr size_t junction_sides = 3;

/// The gaps of a ring, given per side whether it may be hidden. Runs of either kind with fewer
/// than 4 sides count as noise. Directions come from a parabola through the contour beside the
/// gap, over 8 % of the ring's length (8 to 40 sides). O(sides).
KnownContour find_gaps(const LabelRing& ring, std::vector<uint8_t> may_be_hidden);

/// The rings of a part with a smooth arc across every gap; rings of which nothing is known are
/// kept where they are outer ones and filled where they are holes. A part in several pieces becomes
/// one: its contour goes on from each gap at the one that makes the arcs bend least. Nothing where
/// an arc would turn by more than 243 degrees, or pieces have more than six gaps together.
/// O(sides + gaps!).
std::optional<Outline> bridge_gaps(const std::vector<LabelRing>& rings,
                                   const std::vector<KnownContour>& known);

}  // namespace relievo::understanding
