#include "understanding/areas/propose_regions.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/base/exact_functions.h"
#include "kernel/image/morphology.h"
#include "understanding/areas/background.h"
#include "understanding/areas/basin_graph.h"
#include "understanding/areas/find_pieces.h"
#include "understanding/areas/region_merging.h"
#include "understanding/areas/see_through.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int no_region = -1;
constexpr double open_share = 0.24;       ///< of a border without line, above which areas are one
constexpr double different_colour = 55;   ///< of areas that are not one, unless quite open
constexpr double least_step = 30;         ///< of colour across what is open; less is shading
constexpr double quite_open_share = 0.7;  ///< above which colour does not matter
constexpr double outlined_share = 0.8;    ///< of the figure's outline that is ink
constexpr double smallest_part = 0.0008;  ///< of the box around the figure
constexpr double host_share = 0.25;       ///< of a sliver's border, from which it lies on a part
constexpr double detail_share = 0.08;     ///< of the area around it, up to which it is a detail
constexpr double enclosed_share = 0.8;    ///< of a detail's border that is with one region
constexpr size_t usual_parts = 20;        ///< of a character, up to which fragments stay
constexpr double fragment_share = 0.02;   ///< of the figure, below which a part is a fragment
constexpr double one_part = 5.8;          ///< log-odds of two neighbours to be that, of which go
constexpr double marked_weight = 10.3;    ///< of the share of their border that is marked
constexpr double small_weight = 0.73;     ///< of -log of the smaller one's share of the figure
constexpr double large_weight = 2.7;      ///< of the larger one's share of the figure
constexpr double longest_wall = 0.68;     ///< share of a hole's border, that is with one region
constexpr double pale_share = 0.02;       ///< of it, that is with what is like it
constexpr double mark_share = 0.01;       ///< of a hole, that may lie on lines away from its rim
constexpr double like_paint = 35;         ///< distance of mean colours of pieces of one part
constexpr double narrowest_part =
    0.75;  ///< inradius in widths of lines: narrower are gaps in strokes

/// What uniting two neighbours is worth, and what decides between equals; they stay two where the
/// first is not positive.
using Worth = std::function<std::pair<double, int64_t>(int, int)>;

/// Unites neighbours, those of most worth first, until none has any. Nothing is united with
/// `background`; -1 where there is none yet.
class Merger {
 public:
  Merger(RegionMerging& regions, int background, Worth worth)
      : regions_(regions), background_(background), worth_(std::move(worth)) {
    for (int a = 0; a < regions.count(); ++a)
      for (const auto& [b, border] : regions.borders(a))
        if (a < b) propose(a, b);
  }

  void run() {
    while (!queue_.empty()) {
      const auto [worth, a, b] = queue_.top();
      queue_.pop();
      // An entry that later unions made out of date has a newer one.
      if (!regions_.is_region(a) || !regions_.is_region(b) || regions_.borders(a).count(b) == 0 ||
          worth_(a, b) != worth)
        continue;
      regions_.unite(a, b);
      const int merged = std::min(a, b);
      for (const auto& [neighbour, border] : regions_.borders(merged)) propose(merged, neighbour);
    }
  }

 private:
  void propose(int a, int b) {
    if (a == background_ || b == background_) return;
    const auto worth = worth_(a, b);
    if (worth.first > 0) queue_.push({worth, std::min(a, b), std::max(a, b)});
  }

  RegionMerging& regions_;
  int background_;
  Worth worth_;
  std::priority_queue<std::tuple<std::pair<double, int64_t>, int, int>> queue_;
};

/// Unites regions that are open to each other, until lines part all of them.
void unite_open(RegionMerging& regions, int background) {
  Merger(regions, background, [&regions](int a, int b) -> std::pair<double, int64_t> {
    const double share = regions.open_share(a, b);
    const bool changes =
        regions.colour_distance(a, b) > different_colour && regions.colour_step(a, b) > least_step;
    const bool parted = share <= open_share || (share < quite_open_share && changes);
    return {parted ? 0 : share, -regions.borders(a).at(b).pairs};
  }).run();
}

/// Whether ink runs along the outline of the figure.
bool is_outlined(const RegionMerging& regions, int background) {
  int64_t pairs = 0;
  int64_t line_pairs = 0;
  for (const auto& [neighbour, border] : regions.borders(background)) {
    pairs += border.pairs;
    line_pairs += border.line_pairs;
  }
  return static_cast<double>(line_pairs) > outlined_share * static_cast<double>(pairs);
}

int64_t border_length(const RegionMerging& regions, int r) {
  int64_t sum = 0;
  for (const auto& entry : regions.borders(r)) sum += entry.second.pairs;
  return sum;
}

/// Area of the box around all that is not background, px^2.
double figure_box_area(RegionMerging& regions, int background) {
  Box2 box;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) box.add(regions.region(r).box);
  return box.empty() ? 0 : (box.max.x - box.min.x) * (box.max.y - box.min.y);
}

/// Of all that is not background, px.
int64_t figure_area(RegionMerging& regions, int background) {
  int64_t area = 0;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) area += regions.region(r).area;
  return area;
}

/// The neighbour with the longest common border, the background left out, or -1.
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

/// The part on which a region lies: the neighbour with the longest common border, the background
/// only where no part takes a good share of the border. -1 where there is none.
int lies_on(const RegionMerging& regions, int r, int background) {
  const int best = closest_part(regions, r, background);
  const double good = host_share * static_cast<double>(border_length(regions, r));
  const bool lies = best >= 0 && static_cast<double>(regions.borders(r).at(best).pairs) >= good;
  return lies ? best : closest_part(regions, r, no_region);
}

/// Gives regions that are too small or narrow to be parts to those on which they lie, smallest
/// first.
void absorb_slivers(RegionMerging& regions, int background, double least_area,
                    double least_inradius) {
  std::vector<std::pair<int64_t, int>> order;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r)) order.emplace_back(regions.region(r).area, r);
  std::sort(order.begin(), order.end());
  for (const auto& [area, r] : order) {
    if (!regions.is_region(r) || r == background) continue;
    const Basin& region = regions.region(r);
    if (static_cast<double>(region.area) >= least_area && region.inradius >= least_inradius)
      continue;
    const int host = lies_on(regions, r, background);
    if (host >= 0) regions.unite(r, host);
  }
}

/// Gives what lies within one part and is small beside it to that part, smallest first.
void absorb_details(RegionMerging& regions, int background) {
  std::vector<std::pair<int64_t, int>> order;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) order.emplace_back(regions.region(r).area, r);
  std::sort(order.begin(), order.end());
  for (const auto& [area, r] : order) {
    if (!regions.is_region(r)) continue;
    const int around = closest_part(regions, r, no_region);
    if (around < 0 || around == background) continue;
    const auto common = static_cast<double>(regions.borders(r).at(around).pairs);
    const auto host_area = static_cast<double>(regions.region(around).area);
    if (static_cast<double>(regions.region(r).area) < detail_share * host_area &&
        common > enclosed_share * static_cast<double>(border_length(regions, r)))
      regions.unite(r, around);
  }
}

/// Where there are more parts than a character has, unites fragments, as the stripes of a scarf,
/// with what they touch most, smallest first.
void unite_fragments(RegionMerging& regions, int background) {
  const int64_t figure = figure_area(regions, background);
  std::vector<std::pair<int64_t, int>> order;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) order.emplace_back(regions.region(r).area, r);
  std::sort(order.begin(), order.end());
  size_t count = order.size();
  for (const auto& [area, r] : order) {
    if (count <= usual_parts) return;
    const auto least = fragment_share * static_cast<double>(figure);
    if (!regions.is_region(r) || static_cast<double>(regions.region(r).area) >= least) continue;
    const int host = closest_part(regions, r, background);
    if (host < 0) continue;
    regions.unite(r, host);
    --count;
  }
}

/// Unites neighbours that are likelier one part than two: log-odds of that, by how much of their
/// border is marked and by their sizes.
void unite_likely(RegionMerging& regions, int background) {
  const auto figure = static_cast<double>(figure_area(regions, background));
  Merger(regions, background, [&regions, figure](int a, int b) -> std::pair<double, int64_t> {
    const auto [smaller, larger] = std::minmax(regions.region(a).area, regions.region(b).area);
    return {one_part - marked_weight * (1 - regions.open_share(a, b)) -
                small_weight * exact::log(static_cast<double>(smaller) / figure) -
                large_weight * static_cast<double>(larger) / figure,
            0};
  }).run();
}

/// Labels of pixels, region + 1 or 0 for the background. Precondition: fewer than 65535 basins.
Image16 label_image(RegionMerging& regions, const Basins& basins, int background) {
  Image16 labels(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < labels.pixels.size(); ++i) {
    const int region = regions.region_of(basins.index.pixels[i]);
    labels.pixels[i] = static_cast<uint16_t>(region == background ? 0 : region + 1);
  }
  return labels;
}

/// Where the outline of a limb is drawn through the body, gives what they share to the one whose
/// colour it has, and of both to the smaller one: the limb is in front.
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

/// Unites pieces of one paint that are likely one part, as those of a cape to both sides of a leg.
void unite_pieces(RegionMerging& regions, const Basins& basins, int background) {
  if (regions.count() >= std::numeric_limits<uint16_t>::max()) return;
  for (const auto& [a, b] : find_pieces(label_image(regions, basins, background)))
    if (regions.colour_distance(a - 1, b - 1) < like_paint)
      regions.unite(regions.region_of(a - 1), regions.region_of(b - 1));
}

/// Whether a region has the colour of the background and lies between several that have not.
bool may_be_hole(const RegionMerging& regions, int r, int background) {
  const auto is_like_ground = [&](int region) {
    return regions.colour_distance(region, background) < like_paint;
  };
  if (r == background || !is_like_ground(r)) return false;
  int64_t longest = 0;
  int64_t pale = 0;
  for (const auto& [neighbour, border] : regions.borders(r)) {
    longest = std::max(longest, border.pairs);
    pale += is_like_ground(neighbour) ? border.pairs : 0;
  }
  const auto around = static_cast<double>(border_length(regions, r));
  return static_cast<double>(longest) < longest_wall * around &&
         static_cast<double>(pale) < pale_share * around;
}

/// Takes back those regions in which something is drawn, as pupils in eyes: background is empty.
void leave_marked(RegionMerging& regions, const Basins& basins, std::vector<uint8_t>& may_be) {
  Image8 within(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < within.pixels.size(); ++i)
    within.pixels[i] = may_be[regions.region_of(basins.index.pixels[i])];
  within = min_filter(within, static_cast<int>(basins.line_width) + 1);
  std::vector<int64_t> marks(regions.count(), 0);
  for (size_t i = 0; i < within.pixels.size(); ++i)
    if (within.pixels[i] != 0 && basins.barrier.pixels[i] == LineMap::line)
      ++marks[regions.region_of(basins.index.pixels[i])];
  for (int r = 0; r < regions.count(); ++r)
    if (static_cast<double>(marks[r]) > mark_share * static_cast<double>(regions.region(r).area))
      may_be[r] = 0;
}

/// Unites with the background what is seen of it through the figure, which its mask then is
/// without. Returns the background.
int unite_holes(RegionMerging& regions, Basins& basins, int background) {
  std::vector<uint8_t> may_be(regions.count(), 0);
  for (int r = 0; r < regions.count(); ++r)
    may_be[r] = regions.is_region(r) && may_be_hole(regions, r, background) ? 1 : 0;
  const auto none = [&] { return std::find(may_be.begin(), may_be.end(), 1) == may_be.end(); };
  if (basins.figure.said || none() || regions.count() >= std::numeric_limits<uint16_t>::max() - 1)
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

/// Makes bridges of the gaps in outlines that part the figure from the background, and opens the
/// others: inside, strokes end where they like.
void settle_gaps(const Image8& rgb, Basins& basins) {
  std::vector<uint8_t>& barrier = basins.barrier.pixels;
  if (std::find(barrier.begin(), barrier.end(), LineMap::gap) == barrier.end()) return;
  RegionMerging regions(basins);
  unite_open(regions, -1);
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
      const bool parts = is_outside(x - 1, y) != outside || is_outside(x + 1, y) != outside ||
                         is_outside(x, y - 1) != outside || is_outside(x, y + 1) != outside;
      value = parts ? LineMap::bridge : LineMap::none;
    }
  measure_borders(rgb, basins);
}

}  // namespace

void propose_regions(const Image8& rgb, Basins& basins) {
  settle_gaps(rgb, basins);
  RegionMerging regions(basins);
  unite_open(regions, -1);
  int background = unite_background(regions, basins);
  if (background >= 0 && is_outlined(regions, background)) {
    regions.ignore_edges();
    unite_open(regions, background);
  }
  if (background >= 0) unite_overlaps(regions, basins, background);
  const double least_area = smallest_part * figure_box_area(regions, background);
  absorb_slivers(regions, background, least_area,
                 std::max(1.5, narrowest_part * basins.line_width));
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
