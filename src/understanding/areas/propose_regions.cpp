#include "understanding/areas/propose_regions.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "understanding/areas/region_features.h"
#include "understanding/areas/region_merging.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr double smallest_part = 0.0008;  ///< least area of a part, per figure
constexpr double narrowest_part = 0.75;   ///< least inradius of a part, line widths
constexpr double least_inradius = 1.5;    ///< least inradius of a part, px

/// Unites neighbours that are likelier one part than two, the likeliest first.
void unite_parts(RegionMerging& regions, const DrawingMeasure& drawing) {
  Merger merger(regions, [&](int a, int b) { return one_part_odds(regions, drawing, a, b); });
  while (merger.unite_next()) {
  }
}

/// Unites all regions outside the figure. Returns the united one, or -1 where there is none.
int unite_background(RegionMerging& regions, const DrawingMeasure& drawing) {
  std::vector<int> outside;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && figure_odds(regions, drawing, r) < 0) outside.push_back(r);
  int background = -1;
  for (const int r : outside) background = background < 0 ? r : regions.unite(background, r);
  return background;
}

/// Returns the neighbour in the figure that is likeliest one part with a region, or -1.
int likeliest_host(const RegionMerging& regions, const DrawingMeasure& drawing, int r,
                   int background) {
  int best = -1;
  double greatest = 0;
  for (const auto& [neighbour, border] : regions.borders(r)) {
    if (neighbour == background) continue;
    const double odds = one_part_odds(regions, drawing, r, neighbour);
    if (best >= 0 && odds <= greatest) continue;
    best = neighbour;
    greatest = odds;
  }
  return best;
}

/// Unites regions that are too small or too narrow to be parts with their likeliest neighbours in
/// the figure, the smallest first, and with the background where they have none and are very small.
void absorb_slivers(RegionMerging& regions, const DrawingMeasure& drawing, double narrowest,
                    int background) {
  std::vector<int> order;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && r != background) order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&regions](int a, int b) {
    return regions.region(a).area < regions.region(b).area;
  });
  for (const int r : order) {
    if (!regions.is_region(r)) continue;
    const Basin& region = regions.region(r);
    const bool small = static_cast<double>(region.area) < smallest_part * drawing.figure;
    if (!small && region.inradius >= narrowest) continue;
    int host = likeliest_host(regions, drawing, r, background);
    if (host < 0 && small) host = background;
    if (host >= 0) regions.unite(r, host);
  }
}

/// Computes the share of the lines, by area, that have background on all sides.
double unbounded_line_share(const Basins& basins) {
  const int reach = static_cast<int>(basins.line_width) + 1;
  const auto is_background = [&](int x, int y) {
    x = std::clamp(x, 0, basins.index.width - 1);
    y = std::clamp(y, 0, basins.index.height - 1);
    return basins.region[basins.index.at(x, y)] == 0;
  };
  int64_t lines = 0;
  int64_t unbounded = 0;
  for (int y = 0; y < basins.index.height; ++y)
    for (int x = 0; x < basins.index.width; ++x) {
      if (basins.barrier.at(x, y) != LineMap::line) continue;
      ++lines;
      const bool all = is_background(x - reach, y) && is_background(x + reach, y) &&
                       is_background(x, y - reach) && is_background(x, y + reach);
      unbounded += all ? 1 : 0;
    }
  return lines > 0 ? static_cast<double>(unbounded) / static_cast<double>(lines) : 0;
}

}  // namespace

void propose_regions(Basins& basins) {
  RegionMerging regions(basins);
  const DrawingMeasure drawing = measure_drawing(basins);
  unite_parts(regions, drawing);
  int background = unite_background(regions, drawing);
  absorb_slivers(regions, drawing, std::max(least_inradius, narrowest_part * basins.line_width),
                 background);
  if (background >= 0) background = regions.region_of(background);
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
