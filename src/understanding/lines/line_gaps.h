#pragma once

#include <vector>

#include "relievo/point.h"
#include "understanding/lines/line_map.h"
#include "understanding/lines/stroke_ends.h"

namespace relievo::understanding {

/// Two points between which a line is missing.
struct LineGap {
  Point2 a;  ///< px
  Point2 b;
};

/// Finds the loose ends of all lines. O(pixels + ends * length followed).
std::vector<StrokeEnd> find_loose_ends(const LineMap& map);

/// Finds the open roots of limbs, narrowest first: pairs of loose ends, each end in one pair at
/// most. The two strokes run side by side for at least three quarters of the gap's width. Each
/// hides the first other line that it passes on its outer side (a T-junction), as a limb hides the
/// outline of the body; hatching and whiskers hide nothing. No line or edge runs through the gap.
/// `ends` are those of find_loose_ends. O(pixels + ends^2).
std::vector<LineGap> find_open_roots(std::vector<StrokeEnd> ends, const LineMap& map);

/// Finds the breaks in outlines around white. First, pairs of ends, narrowest gap first: each
/// stroke can continue to the other's end with a turn of less than 50 degrees (after Kellman,
/// Shipley: A theory of visual interpolation in object perception, 1991), and the strokes are
/// together 1.5 times as long as the gap. Then, single ends whose strokes would run straight into
/// another line or a dark shape. No paint lies beside the ends. `ends` are those of
/// find_loose_ends, `rgb` is the drawing on white. O(ends^2 + ends * widest gap).
std::vector<LineGap> find_broken_outlines(std::vector<StrokeEnd> ends, const LineMap& map,
                                          const Image8& rgb);

/// Marks a gap in `barrier` where there is no line or edge.
void close_gap(const LineGap& gap, LineMap::Barrier as, Image8& barrier);

}  // namespace relievo::understanding
