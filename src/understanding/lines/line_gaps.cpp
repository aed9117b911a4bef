#include "understanding/lines/line_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"
#include "understanding/lines/stroke_ends.h"

namespace relievo::understanding {
namespace {

// Lengths are per diagonal of the picture where no unit is given.
constexpr double longest_followed = 0.25;  ///< length up to which a stroke is followed from its end
constexpr double length_per_gap = 0.75;    ///< least length of a stroke over the width of its gap
constexpr double side_cosine = 0.7;   ///< least cosine of the angle between both sides of a limb
constexpr double root_cosine = 0.75;  ///< largest cosine of the angle between sides and root
constexpr double narrowest_root = 3;  ///< least width of an open root, line widths
constexpr double shortest_outline = 0.06;  ///< length below which a stroke is texture
constexpr double widest_break = 0.12;      ///< largest gap between two ends
constexpr double widest_contact = 0.05;    ///< largest gap between an end and a line
constexpr double onward_cosine = 0.64;     ///< least cosine of the turn from a stroke to the gap

/// Calls visit(x, y) for the pixels from `a` to `b`, each of which shares a side with the next.
template <class Visit>
void for_pixels_between(Point2 a, Point2 b, const Visit& visit) {
  const int steps = 2 * static_cast<int>(std::ceil(distance(a, b)));
  int last_x = static_cast<int>(a.x);
  for (int k = 0; k <= steps; ++k) {
    const Point2 p = a + (static_cast<double>(k) / steps) * (b - a);
    const int x = static_cast<int>(p.x);
    const int y = static_cast<int>(p.y);
    if (x != last_x) visit(last_x, y);
    visit(x, y);
    last_x = x;
  }
}

/// Returns 1 for the cells of `side` px that contain a pixel of a line.
Image8 line_cells(const Image8& barrier, int side) {
  Image8 cells((barrier.width + side - 1) / side, (barrier.height + side - 1) / side, 1);
  for (int y = 0; y < barrier.height; ++y) {
    const uint8_t* row = &barrier.at(0, y);
    uint8_t* out = &cells.at(0, y / side);
    for (int x = 0; x < barrier.width; ++x)
      if (row[x] == LineMap::line) out[x / side] = 1;
  }
  return cells;
}

/// Returns whether paint, which is not white, lies beside a stroke near its end.
bool bounds_paint(const StrokeEnd& end, double line_width, const Image8& rgb) {
  const Point2 aside{-end.inwards.y, end.inwards.x};
  for (const double along : {1.0, 2.5})
    for (const double beside : {-1.5, 1.5}) {
      const Point2 p = end.at + line_width * (along * end.inwards + beside * aside);
      const int x = std::clamp(static_cast<int>(p.x), 0, rgb.width - 1);
      const int y = std::clamp(static_cast<int>(p.y), 0, rgb.height - 1);
      if (darkest_channel(rgb, x, y) < palest_paint) return true;
    }
  return false;
}

/// Returns whether a stroke hides what lies on its other side than `point`.
bool hides_outer_side(const StrokeEnd& end, Point2 point) {
  return cross(end.inwards, point - end.at) * end.hidden_side < 0;
}

/// Returns whether two strokes may be the sides of a limb whose root, between their ends, is open.
bool are_sides_of_limb(const StrokeEnd& a, const StrokeEnd& b, double line_width) {
  const double gap = distance(a.at, b.at);
  if (gap < narrowest_root * line_width) return false;
  if (std::min(a.length, b.length) < length_per_gap * gap) return false;
  if (dot(a.inwards, b.inwards) < side_cosine) return false;
  const Point2 middle = a.inwards + b.inwards;
  if (std::abs(dot(middle, b.at - a.at)) > root_cosine * gap * norm(middle)) return false;
  return hides_outer_side(a, b.at) && hides_outer_side(b, a.at);
}

/// Returns whether each stroke can continue to the other's end with small turns.
bool face_each_other(const StrokeEnd& a, const StrokeEnd& b, double widest) {
  const double gap = distance(a.at, b.at);
  if (gap > std::min(widest, (a.length + b.length) / 2 / length_per_gap)) return false;
  const Point2 way = b.at - a.at;
  const double towards = std::min(-dot(a.inwards, way), dot(b.inwards, way));
  return towards > onward_cosine * gap && dot(a.inwards, b.inwards) < 0;
}

/// Returns whether no line or edge runs through a gap, beyond the lines at its own ends.
bool is_clear(const Image8& barrier, const LineGap& gap, double line_width) {
  bool clear = true;
  for_pixels_between(gap.a, gap.b, [&](int x, int y) {
    const Point2 p{x + 0.5, y + 0.5};
    if (std::min(distance(p, gap.a), distance(p, gap.b)) > line_width + 1)
      clear = clear && barrier.at(x, y) == LineMap::none;
  });
  return clear;
}

bool is_end_of(const std::vector<LineGap>& gaps, Point2 end) {
  return std::any_of(gaps.begin(), gaps.end(),
                     [end](const LineGap& gap) { return gap.a == end || gap.b == end; });
}

/// Pairs the ends for which belong(a, b) is true, narrowest gap first and each end once at most,
/// where no line or edge runs between them.
template <class Belong>
std::vector<LineGap> pair_ends(const std::vector<StrokeEnd>& ends, const LineMap& map,
                               const Belong& belong) {
  std::vector<LineGap> pairs;
  for (size_t i = 0; i < ends.size(); ++i)
    for (size_t j = i + 1; j < ends.size(); ++j)
      if (belong(ends[i], ends[j])) pairs.push_back({ends[i].at, ends[j].at});
  std::stable_sort(pairs.begin(), pairs.end(), [](const LineGap& x, const LineGap& y) {
    return distance(x.a, x.b) < distance(y.a, y.b);
  });
  std::vector<LineGap> chosen;
  for (const LineGap& gap : pairs)
    if (!is_end_of(chosen, gap.a) && !is_end_of(chosen, gap.b) &&
        is_clear(map.barrier, gap, map.line_width))
      chosen.push_back(gap);
  return chosen;
}

bool lies_on(const Image8& image, Point2 p) {
  return p.x >= 0 && p.y >= 0 && p.x < image.width && p.y < image.height;
}

/// Returns whether a stroke that continued straight on for `way` px and half a line's width more
/// would be over ink.
bool is_ink_beyond(const StrokeEnd& end, double way, double line_width, const Image8& rgb) {
  const Point2 p = end.at - (way + line_width / 2) * end.inwards;
  return lies_on(rgb, p) && is_dark(&rgb.at(static_cast<int>(p.x), static_cast<int>(p.y)));
}

/// Finds the gap between an end and the line or dark shape that its stroke, continued straight on
/// for up to `widest` px, would meet.
std::optional<LineGap> gap_ahead(const StrokeEnd& end, const LineMap& map, const Image8& rgb,
                                 double widest) {
  const double reach = std::min(widest, end.length / length_per_gap);
  for (double t = map.line_width + 1; t < reach; t += 0.5) {
    const Point2 p = end.at - t * end.inwards;
    if (!lies_on(map.barrier, p)) return std::nullopt;
    const uint8_t barrier = map.barrier.at(static_cast<int>(p.x), static_cast<int>(p.y));
    if (barrier == LineMap::none) continue;
    if (barrier == LineMap::line || is_ink_beyond(end, t, map.line_width, rgb))
      return LineGap{end.at, p};
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<StrokeEnd> find_loose_ends(const LineMap& map) {
  // Wide lines are slow to thin, so this works on cells of a third of the lines' width.
  const int side = std::max(1, static_cast<int>(map.line_width / 3));
  const Image8 cells = line_cells(map.barrier, side);
  const double longest = longest_followed * std::hypot(cells.width, cells.height);
  std::vector<StrokeEnd> ends = find_stroke_ends(thin(cells), map.line_width / side, longest);
  for (StrokeEnd& end : ends) {
    end.at = static_cast<double>(side) * end.at;
    end.length *= side;
  }
  return ends;
}

std::vector<LineGap> find_open_roots(std::vector<StrokeEnd> ends, const LineMap& map) {
  std::erase_if(ends, [](const StrokeEnd& end) { return end.hidden_side == 0; });
  return pair_ends(ends, map, [&map](const StrokeEnd& a, const StrokeEnd& b) {
    return are_sides_of_limb(a, b, map.line_width);
  });
}

std::vector<LineGap> find_broken_outlines(std::vector<StrokeEnd> ends, const LineMap& map,
                                          const Image8& rgb) {
  if (map.painted)
    std::erase_if(ends,
                  [&](const StrokeEnd& end) { return bounds_paint(end, map.line_width, rgb); });
  const double diagonal = std::hypot(map.barrier.width, map.barrier.height);
  std::erase_if(
      ends, [diagonal](const StrokeEnd& end) { return end.length < shortest_outline * diagonal; });
  const auto belong = [diagonal](const StrokeEnd& a, const StrokeEnd& b) {
    return face_each_other(a, b, widest_break * diagonal);
  };
  std::vector<LineGap> gaps = pair_ends(ends, map, belong);
  for (const StrokeEnd& end : ends)
    if (!is_end_of(gaps, end.at))
      if (const auto gap = gap_ahead(end, map, rgb, widest_contact * diagonal))
        gaps.push_back(*gap);
  return gaps;
}

void close_gap(const LineGap& gap, LineMap::Barrier as, Image8& barrier) {
  for_pixels_between(gap.a, gap.b, [&](int x, int y) {
    uint8_t& value = barrier.at(x, y);
    if (value == LineMap::none) value = as;
  });
}

}  // namespace relievo::understanding
