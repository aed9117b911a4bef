#pragma once

#include <vector>

#include "relievo/point.h"
#include "understanding/lines/line_map.h"
#include "understanding/lines/stroke_ends.h"

namespace relievo::understanding {

/// Two places between which a line is missing.
struct LineGap {
  Point2 a;  ///< px
  Point2 b;
};

/// Finds the open roots of limbs: pairs of loose ends side by side, narrowest first, each end in
/// one pair at most. Both strokes run the same way for longer than the gap between them is wide,
/// and the first other lines that they come across end at their outer sides, as outlines do that a
/// limb hides; hatching and whiskers do not hide what they cross. No line or edge runs between the
/// ends. `ends` are those of find_loose_ends. O(pixels + ends^2).
std::vector<LineGap> find_open_roots(std::vector<StrokeEnd> ends, const LineMap& map);

/// Finds where outlines around white are broken: strokes without paint beside their ends, together
/// longer than one and a half gaps, of which each would go on to the other's end by a bend of less
/// than a right angle (Kellman, Shipley: A theory of visual interpolation in object perception,
/// 1991), narrowest first, or of which one would run straight into another line or a dark shape.
/// `rgb` is the drawing on white. O(ends^2 + ends * widest gap).
std::vector<LineGap> find_broken_outlines(std::vector<StrokeEnd> ends, const LineMap& map,
                                          const Image8& rgb);

/// The loose ends of all lines. O(pixels + ends * length followed).
std::vector<StrokeEnd> find_loose_ends(const LineMap& map);

/// Marks the way from one end to the other where there is no line or edge.
void close_gap(const LineGap& gap, LineMap::Barrier as, Image8& barrier);

}  // namespace relievo::understanding
