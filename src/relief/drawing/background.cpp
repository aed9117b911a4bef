#include "relief/drawing/background.h"

#include <algorithm>
#include <array>

#include "relief/drawing/line_map.h"

namespace relievo {
namespace {

constexpr double paper_distance = 70;      ///< from white within which background may be, of 255
constexpr double cut_figure_share = 0.12;  ///< of the picture, from which on a region is a figure
constexpr double opaque_share = 0.05;      ///< of the picture off the lines: fills, not blots
constexpr double spread_distance = 45;     ///< of mean colours, up to which background spreads
constexpr double leak_width = 0.7;         ///< px of gap per px of inradius from which it spreads
constexpr double leak_share = 0.07;        ///< open share of a border through which it spreads

double distance_from_white(const Basin& region) {
  if (region.coloured == 0) return 0;
  double farthest = 0;
  for (const int64_t sum : region.colour_sum)
    farthest =
        std::max(farthest, 255 - static_cast<double>(sum) / static_cast<double>(region.coloured));
  return farthest;
}

bool is_paper(const Basin& region) { return distance_from_white(region) < paper_distance; }

bool reaches_outside(const Basin& region, int64_t picture_area) {
  const auto edges = std::count_if(region.at_edge.begin(), region.at_edge.end(),
                                   [](int64_t pixels) { return pixels > 0; });
  if (edges == 0 || !is_paper(region)) return false;
  return edges > 1 ||
         static_cast<double>(region.area) < cut_figure_share * static_cast<double>(picture_area);
}

/// Whether the drawing has opaque areas, so that transparent ones are none of the figure.
bool has_opaque_areas(RegionMerging& regions) {
  int64_t transparent = 0;
  int64_t all = 0;
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r)) continue;
    transparent += regions.region(r).transparent;
    all += regions.region(r).coloured;
  }
  return transparent > 0 &&
         static_cast<double>(all - transparent) > opaque_share * static_cast<double>(all);
}

bool is_transparent(const Basin& region) { return 2 * region.transparent > region.coloured; }

/// The neighbour through whose border the background spreads most easily, or -1.
int leaking_neighbour(const RegionMerging& regions, int background) {
  int best = -1;
  double widest = leak_share;
  for (const auto& [neighbour, border] : regions.borders(background)) {
    const double share = regions.open_share(background, neighbour);
    const double gap = share * static_cast<double>(border.pairs);
    if (gap < leak_width * regions.region(neighbour).inradius) continue;
    if (share <= widest || regions.colour_distance(background, neighbour) > spread_distance)
      continue;
    widest = share;
    best = neighbour;
  }
  return best;
}

}  // namespace

int unite_background(RegionMerging& regions, int64_t picture_area) {
  const bool opaque = has_opaque_areas(regions);
  int background = -1;
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r)) continue;
    const Basin& region = regions.region(r);
    if (!reaches_outside(region, picture_area) && !(opaque && is_transparent(region))) continue;
    if (background < 0)
      background = r;
    else
      regions.unite(background, r);
  }
  if (background < 0) return background;
  for (int r = leaking_neighbour(regions, background); r >= 0;
       r = leaking_neighbour(regions, background)) {
    regions.unite(background, r);
    background = std::min(background, r);
  }
  return background;
}

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

}  // namespace relievo
