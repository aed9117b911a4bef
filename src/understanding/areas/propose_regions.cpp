#include "understanding/areas/propose_regions.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "kernel/base/exact_functions.h"
#include "kernel/image/components.h"
#include "kernel/image/morphology.h"
#include "understanding/areas/basin_graph.h"
#include "understanding/areas/find_pieces.h"
#include "understanding/areas/region_merging.h"
#include "understanding/areas/see_through.h"
#include "understanding/areas/unite_background.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int no_region = -1;
// Distances of colours are of 255 a channel.
constexpr double open_share = 0.24;       ///< open share of a border above which areas are one
constexpr double different_colour = 55;   ///< distance of mean colours of different areas
constexpr double least_step = 30;         ///< least step of colour at their border; less is shading
constexpr double quite_open_share = 0.7;  ///< open share above which colours do not matter
constexpr double outlined_share = 0.8;    ///< inked share of the outline of an outlined figure
constexpr double smallest_part = 0.0008;  ///< least area of a part, per box around the figure
constexpr double narrowest_part = 0.75;   ///< least inradius of a part, line widths
constexpr double least_inradius = 1.5;    ///< least inradius of a part, px
constexpr double host_share = 0.25;  ///< least share of a sliver's border with the part it lies on
constexpr double detail_share = 0.08;    ///< largest area of a detail, per area around it
constexpr double enclosed_share = 0.8;   ///< least share of its border with the area around it
constexpr size_t usual_parts = 20;       ///< parts of a character above which fragments unite
constexpr double fragment_share = 0.02;  ///< largest area of a fragment, per figure
// Weights of the log-odds that two neighbours are one part (see unite_likely), from a logistic
// regression on drawings with known parts (docs/understanding/segmentation.md).
constexpr double one_part = 5.8;
constexpr double marked_weight = 10.3;
constexpr double small_weight = 0.73;
constexpr double large_weight = 2.7;
constexpr double longest_wall = 0.68;  ///< largest share of a hole's border with one region
constexpr double pale_share = 0.02;    ///< largest share with regions of the background's colour
constexpr double mark_share = 0.01;    ///< largest area of lines inside a hole, per hole
constexpr double like_paint = 35;      ///< largest distance of mean colours of one paint

/// Unites regions that are open to each other and none of which is `background` (or no_region), the
/// most open first, until lines separate all of them.
void unite_open(RegionMerging& regions, int background) {
  Merger merger(regions, [&](int a, int b) -> std::pair<double, int64_t> {
    const double share = regions.open_share(a, b);
    const bool changes =
        regions.colour_distance(a, b) > different_colour && regions.colour_step(a, b) > least_step;
    const bool apart = a == background || b == background || share <= open_share ||
                       (share < quite_open_share && changes);
    return {apart ? -1 : share, -regions.borders(a).at(b).pairs};
  });
  while (merger.unite_next()) {
  }
}

/// Returns whether ink runs along the outline of the figure.
bool is_outlined(const RegionMerging& regions, int background) {
  const Border outline = regions.whole_border(background);
  return static_cast<double>(outline.line_pairs) >
         outlined_share * static_cast<double>(outline.pairs);
}

double border_length(const RegionMerging& regions, int r) {
  return static_cast<double>(regions.whole_border(r).pairs);
}

/// Computes the area of the box around all regions except the background, px^2.
double figure_box_area(RegionMerging& regions, int background) {
  Box2 box;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) box.add(regions.region(r).box);
  return box.empty() ? 0 : (box.max.x - box.min.x) * (box.max.y - box.min.y);
}

/// Computes the area of all regions except the background, px.
int64_t figure_area(RegionMerging& regions, int background) {
  int64_t area = 0;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) area += regions.region(r).area;
  return area;
}

/// Lists the regions except the background, the smallest first.
std::vector<int> smallest_first(RegionMerging& regions, int background) {
  std::vector<int> order;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&regions](int a, int b) {
    return regions.region(a).area < regions.region(b).area;
  });
  return order;
}

/// Returns the neighbour with the longest common border, except the background, or -1.
int closest_part(const RegionMerging& regions, int r, int background) {
  int best = -1;
  int64_t longest = 0;
  for (const auto& [neighbour, border] : regions.borders(r))
    if (neighbour != background && border.pairs > longest) {
      longest = border.pairs;
      best = neighbour;
    }
  return best;
}

/// Returns the neighbour on which a region lies, the one with the longest common border, or -1. It
/// is the background only where no other has a good share of the border.
int lies_on(const RegionMerging& regions, int r, int background) {
  const int best = closest_part(regions, r, background);
  const double good = host_share * border_length(regions, r);
  const bool lies = best >= 0 && static_cast<double>(regions.borders(r).at(best).pairs) >= good;
  return lies ? best : closest_part(regions, r, no_region);
}

/// Unites regions that are too small, px, or too narrow to be parts with those on which they lie,
/// the smallest first.
void absorb_slivers(RegionMerging& regions, int background, double least_area, double narrowest) {
  for (const int r : smallest_first(regions, background)) {
    if (!regions.is_region(r)) continue;
    const Basin& region = regions.region(r);
    if (static_cast<double>(region.area) >= least_area && region.inradius >= narrowest) continue;
    const int host = lies_on(regions, r, background);
    if (host >= 0) regions.unite(r, host);
  }
}

/// Unites regions that lie inside one part and are small compared with it with that part, the
/// smallest first.
void absorb_details(RegionMerging& regions, int background) {
  for (const int r : smallest_first(regions, background)) {
    if (!regions.is_region(r)) continue;
    const int around = closest_part(regions, r, no_region);
    if (around < 0 || around == background) continue;
    const auto common = static_cast<double>(regions.borders(r).at(around).pairs);
    const auto host_area = static_cast<double>(regions.region(around).area);
    if (static_cast<double>(regions.region(r).area) < detail_share * host_area &&
        common > enclosed_share * border_length(regions, r))
      regions.unite(r, around);
  }
}

/// Unites fragments, such as the stripes of a scarf, with the regions that they touch most, the
/// smallest first, while there are more parts than a character has.
void unite_fragments(RegionMerging& regions, int background) {
  const int64_t figure = figure_area(regions, background);
  const std::vector<int> order = smallest_first(regions, background);
  size_t count = order.size();
  for (const int r : order) {
    if (count <= usual_parts) return;
    const auto least = fragment_share * static_cast<double>(figure);
    if (!regions.is_region(r) || static_cast<double>(regions.region(r).area) >= least) continue;
    const int host = closest_part(regions, r, background);
    if (host < 0) continue;
    regions.unite(r, host);
    --count;
  }
}

/// Unites neighbours that are likelier one part than two, the likeliest first. The log-odds are
///   w0 - w1 m - w2 log s - w3 l
/// with the marked share m of their border and the areas s and l of the smaller and the larger one,
/// per figure.
void unite_likely(RegionMerging& regions, int background) {
  const auto figure = static_cast<double>(figure_area(regions, background));
  Merger merger(regions, [&, figure](int a, int b) -> std::pair<double, int64_t> {
    if (a == background || b == background) return {-1, 0};
    const auto [smaller, larger] = std::minmax(regions.region(a).area, regions.region(b).area);
    return {one_part - marked_weight * (1 - regions.open_share(a, b)) -
                small_weight * exact::log(static_cast<double>(smaller) / figure) -
                large_weight * static_cast<double>(larger) / figure,
            0};
  });
  while (merger.unite_next()) {
  }
}

/// Returns the label of every pixel, 0 on the background and region + 1 elsewhere. Precondition:
/// fewer than 65535 basins.
Image16 label_image(RegionMerging& regions, const Basins& basins, int background) {
  Image16 labels(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i) {
    const int region = regions.region_of(basins.index.pixels[i]);
    labels.pixels[i] = static_cast<uint16_t>(region == background ? 0 : region + 1);
  }
  return labels;
}

/// Gives the area that a limb and the body share, where the limb's outline is drawn through the
/// body, to the one whose colour it has. Where it has the colour of both it goes to the smaller
/// one, since the limb is in front.
void unite_overlaps(RegionMerging& regions, const Basins& basins, int background) {
  if (regions.count() >= std::numeric_limits<uint16_t>::max()) return;
  const Image16 labels = label_image(regions, basins, background);
  for (const SharedArea& overlap : find_shared_areas(labels, basins.line_width)) {
    const auto now = [&](uint16_t label) { return regions.region_of(label - 1); };
    const int shared = now(overlap.shared);
    int front = now(overlap.a);
    int behind = now(overlap.b);
    const auto like = [&](int part) {
      return regions.colour_distance(shared, part) < different_colour;
    };
    const bool larger = regions.region(front).area > regions.region(behind).area;
    if (like(behind) && (larger || !like(front))) std::swap(front, behind);
    if (shared != front && shared != behind && like(front)) regions.unite(shared, front);
  }
}

/// Unites pieces of one colour that are likely one part, such as a cape on both sides of a leg.
void unite_pieces(RegionMerging& regions, const Basins& basins, int background) {
  if (regions.count() >= std::numeric_limits<uint16_t>::max()) return;
  for (const auto& [a, b] : find_pieces(label_image(regions, basins, background)))
    if (regions.colour_distance(a - 1, b - 1) < like_paint)
      regions.unite(regions.region_of(a - 1), regions.region_of(b - 1));
}

/// Returns whether a region has the colour of the background and lies between several regions of
/// other colours.
bool may_be_hole(const RegionMerging& regions, int r, int background) {
  const auto is_like_background = [&](int region) {
    return regions.colour_distance(region, background) < like_paint;
  };
  if (r == background || !is_like_background(r)) return false;
  int64_t longest = 0;
  int64_t pale = 0;
  for (const auto& [neighbour, border] : regions.borders(r)) {
    longest = std::max(longest, border.pairs);
    pale += is_like_background(neighbour) ? border.pairs : 0;
  }
  const double around = border_length(regions, r);
  return static_cast<double>(longest) < longest_wall * around &&
         static_cast<double>(pale) < pale_share * around;
}

/// Clears `may_be` of regions in which something is drawn, such as pupils in eyes, since background
/// is empty.
void leave_marked(RegionMerging& regions, const Basins& basins, std::vector<uint8_t>& may_be) {
  const Image8 inside = mask_where(basins.index.width, basins.index.height, [&](size_t i) {
    return may_be[regions.region_of(basins.index.pixels[i])] != 0;
  });
  const Image8 within = min_filter(inside, static_cast<int>(basins.line_width) + 1);
  std::vector<int64_t> marks(regions.count(), 0);
  for (size_t i = 0; i < within.pixels.size(); ++i)
    if (within.pixels[i] != 0 && basins.barrier.pixels[i] == LineMap::line)
      ++marks[regions.region_of(basins.index.pixels[i])];
  for (int r = 0; r < regions.count(); ++r)
    if (static_cast<double>(marks[r]) > mark_share * static_cast<double>(regions.region(r).area))
      may_be[r] = 0;
}

/// Unites the background with the areas where it is seen through the figure, and removes these from
/// the figure's mask. Returns the background.
int unite_holes(RegionMerging& regions, Basins& basins, int background) {
  std::vector<uint8_t> may_be(regions.count(), 0);
  for (int r = 0; r < regions.count(); ++r)
    may_be[r] = regions.is_region(r) && may_be_hole(regions, r, background) ? 1 : 0;
  const auto none = [&] { return std::find(may_be.begin(), may_be.end(), 1) == may_be.end(); };
  if (basins.figure.cut_out || none() ||
      regions.count() >= std::numeric_limits<uint16_t>::max() - 1)
    return background;
  leave_marked(regions, basins, may_be);
  if (none()) return background;
  std::vector<uint8_t> is_hole(regions.count(), 0);
  for (const HoleCue& cue : find_holes(label_image(regions, basins, background)))
    if (may_be[cue.area - 1] != 0 &&
        regions.colour_distance(cue.before - 1, cue.after - 1) < like_paint)
      is_hole[cue.area - 1] = 1;
  for (size_t b = 0; b < basins.basins.size(); ++b)
    if (is_hole[regions.region_of(static_cast<int>(b))] != 0) basins.basins[b].in_figure = 0;
  for (size_t i = 0; i < basins.figure.inside.pixels.size(); ++i)
    if (is_hole[regions.region_of(basins.index.pixels[i])] != 0) basins.figure.inside.pixels[i] = 0;
  for (int r = 0; r < regions.count(); ++r)
    if (is_hole[r] != 0) regions.unite(background, r);
  return regions.region_of(background);
}

/// Turns the gaps that separate figure and background into bridges, and opens the others, since
/// strokes end anywhere inside a figure.
void settle_gaps(const Image8& rgb, Basins& basins) {
  std::vector<uint8_t>& barrier = basins.barrier.pixels;
  if (std::find(barrier.begin(), barrier.end(), LineMap::gap) == barrier.end()) return;
  RegionMerging regions(basins);
  unite_open(regions, no_region);
  const int background = unite_background(regions, basins);
  const int w = basins.index.width;
  const int h = basins.index.height;
  const auto is_outside = [&](int x, int y) {
    const int basin = basins.index.at(std::clamp(x, 0, w - 1), std::clamp(y, 0, h - 1));
    return regions.region_of(basin) == background;
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      uint8_t& value = basins.barrier.at(x, y);
      if (value != LineMap::gap) continue;
      const bool outside = is_outside(x, y);
      const auto sides = side_neighbours(x, y);
      const bool separates = std::any_of(sides.begin(), sides.end(), [&](const auto& side) {
        return is_outside(side.first, side.second) != outside;
      });
      value = separates ? LineMap::bridge : LineMap::none;
    }
  measure_borders(rgb, basins);
}

}  // namespace

void propose_regions(const Image8& rgb, Basins& basins) {
  settle_gaps(rgb, basins);
  RegionMerging regions(basins);
  unite_open(regions, no_region);
  int background = unite_background(regions, basins);
  if (background >= 0 && is_outlined(regions, background)) {
    regions.ignore_edges();
    unite_open(regions, background);
  }
  if (background >= 0) unite_overlaps(regions, basins, background);
  const double least_area = smallest_part * figure_box_area(regions, background);
  absorb_slivers(regions, background, least_area,
                 std::max(least_inradius, narrowest_part * basins.line_width));
  if (background >= 0) background = regions.region_of(background);
  absorb_details(regions, background);
  unite_fragments(regions, background);
  unite_likely(regions, background);
  if (background >= 0) background = unite_holes(regions, basins, background);
  if (background >= 0) unite_pieces(regions, basins, background);

  std::vector<int> number(basins.basins.size(), -1);
  basins.region.resize(basins.basins.size());
  for (size_t b = 0; b < basins.basins.size(); ++b) {
    const int r = regions.region_of(static_cast<int>(b));
    if (number[r] < 0) number[r] = r == background ? 0 : ++basins.region_count;
    basins.region[b] = number[r];
  }
  basins.unbounded_ink = unbounded_line_share(basins);
}

}  // namespace relievo::understanding
