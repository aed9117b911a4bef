#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/geometry/polyline.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {

/// A run of a ring that another part may hide, where the part's own contour is unknown.
struct ContourGap {
  size_t first = 0;    ///< index of its first side in the ring
  size_t count = 0;    ///< number of sides
  DirectedPoint from;  ///< where the known contour ends, and its direction there
  DirectedPoint to;    ///< where the known contour continues
};

/// The known and the hidden sides of a ring.
struct KnownContour {
  std::vector<ContourGap> gaps;  ///< in the order of the ring
  bool nothing = false;          ///< the whole ring may be hidden
  std::vector<uint8_t> hidden;   ///< per side, 1 in a gap
};

/// The sides of a contour next to a junction of three labels that are ignored, because the width of
/// the lines there displaces them.
constexpr size_t junction_sides = 3;

/// Finds the gaps of a ring, given per side whether it may be hidden. Runs of either kind with
/// fewer than 4 sides count as noise. Directions come from a parabola through the contour beside
/// the gap, over 8 % of the ring's length (8 to 40 sides). O(sides).
KnownContour find_gaps(const LabelRing& ring, std::vector<uint8_t> may_be_hidden);

/// Bridges every gap of a part's rings by a smooth arc. Rings of which nothing is known are kept
/// where they are outer ones, and filled where they are holes. The rings of a part in several
/// pieces, which may have six gaps together, are connected: of all ways to continue from each gap
/// at another, those that make one contour of all pieces are kept, and of these the one whose arcs
/// bend least is taken. Returns nothing where there are more gaps, or an arc would turn by more
/// than 243 degrees. O(sides + gaps!).
std::optional<Outline> bridge_gaps(const std::vector<LabelRing>& rings,
                                   const std::vector<KnownContour>& known);

}  // namespace relievo::understanding
