#include "understanding/areas/background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask_pieces.h"
#include "kernel/image/morphology.h"
#include "understanding/figure/figure_mask.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/page.h"

namespace relievo::understanding {
namespace {

constexpr double page_share = 0.35;    ///< of the picture, at least
constexpr double quad_share = 0.8;     ///< of a page and what lies between its corners, in common
constexpr double paper_distance = 70;  ///< from white within which background may be, of 255
constexpr double cut_figure_share = 0.12;  ///< of the picture, from which on a region is a figure
constexpr double cut_share = 0.12;         ///< of a region's rim, up to which an edge cuts it off
constexpr double cut_line_share = 0.8;     ///< of the rest, which are lines then
constexpr double open_page_share = 0.3;    ///< of the picture's edge, that a page reaches at most
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

int64_t pixels_at_edge(const Basin& region) {
  return std::accumulate(region.at_edge.begin(), region.at_edge.end(), int64_t{0});
}

/// Whether lines bound the region but for the little of it that the picture's edge cuts: a hand
/// and not the paper beside it.
bool is_cut_off(const RegionMerging& regions, int r) {
  const int64_t at_edge = pixels_at_edge(regions.region(r));
  int64_t pairs = 0;
  int64_t line_pairs = 0;
  for (const auto& [neighbour, border] : regions.borders(r)) {
    pairs += border.pairs;
    line_pairs += border.line_pairs;
  }
  return static_cast<double>(at_edge) < cut_share * static_cast<double>(at_edge + pairs) &&
         static_cast<double>(line_pairs) > cut_line_share * static_cast<double>(pairs);
}

bool reaches_outside(const RegionMerging& regions, int r, int64_t picture_area) {
  const Basin& region = regions.region(r);
  const auto edges = std::count_if(region.at_edge.begin(), region.at_edge.end(),
                                   [](int64_t pixels) { return pixels > 0; });
  if (edges == 0 || !is_paper(region)) return false;
  if (edges > 1) return true;
  return static_cast<double>(region.area) < cut_figure_share * static_cast<double>(picture_area) &&
         !is_cut_off(regions, r);
}

/// Adds to the background what lies around the page of a photograph.
int add_surroundings(RegionMerging& regions, const Basins& basins, int background) {
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r) || r == background || is_in_figure(regions.region(r))) continue;
    const Basin& region = regions.region(r);
    if (!is_surroundings(region.at_edge, region.area, basins.index.width, basins.index.height))
      continue;
    regions.unite(background, r);
    background = std::min(background, r);
  }
  return background;
}

/// A region with all that it surrounds.
Image8 filled(RegionMerging& regions, const Basins& basins, int r) {
  Image8 mask(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = regions.region_of(basins.index.pixels[i]) == r ? 1 : 0;
  return without_holes(mask);
}

/// [drawing size] The region `paper` with all that it surrounds, 1, where that is a page: a
/// quadrilateral on a good part of the picture with hardly any paper around it; else empty.
Image8 find_page(RegionMerging& regions, const Basins& basins, int paper) {
  const Image8 page = filled(regions, basins, paper);
  const auto area = std::count(page.pixels.begin(), page.pixels.end(), 1);
  const auto all = static_cast<int64_t>(page.pixels.size());
  if (static_cast<double>(area) < page_share * static_cast<double>(all) ||
      page_overlap(page) < quad_share)
    return {};
  int64_t paper_around = 0;
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (page.pixels[i] == 0)
      paper_around += is_paper(regions.region(regions.region_of(basins.index.pixels[i]))) ? 1 : 0;
  return 2 * paper_around < all - area ? page : Image8{};
}

/// Unites what lies around the page with the background, takes the lines there out and returns the
/// background.
int unite_around_page(RegionMerging& regions, Basins& basins, const Image8& page, int background) {
  std::vector<int64_t> around(regions.count(), 0);
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (page.pixels[i] == 0) ++around[regions.region_of(basins.index.pixels[i])];
  for (int r = 0; r < regions.count(); ++r) {
    if (r == background || !regions.is_region(r) || 2 * around[r] <= regions.region(r).area)
      continue;
    regions.unite(background, r);
    background = std::min(background, r);
  }
  const Image8 within = min_filter(page, static_cast<int>(basins.line_width) + 1);
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (within.pixels[i] == 0) {
      basins.barrier.pixels[i] = LineMap::none;
      basins.ink.pixels[i] = 0;
    }
  return background;
}

/// Where the largest area of paper is a page with something else around it, adds both.
int add_page(RegionMerging& regions, Basins& basins, int background) {
  int paper = -1;
  for (int r = 0; r < regions.count(); ++r)
    if (regions.is_region(r) && is_paper(regions.region(r)) && !is_in_figure(regions.region(r)) &&
        (paper < 0 || regions.region(r).area > regions.region(paper).area))
      paper = r;
  if (paper < 0) return background;
  const int64_t at_edge = pixels_at_edge(regions.region(paper));
  const double perimeter = 2.0 * (basins.index.width + basins.index.height);
  if (static_cast<double>(at_edge) > open_page_share * perimeter) return background;
  const Image8 page = find_page(regions, basins, paper);
  if (page.empty()) return background;
  if (background >= 0 && background != paper) regions.unite(background, paper);
  return unite_around_page(regions, basins, page,
                           background < 0 ? paper : std::min(background, paper));
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
    if (is_in_figure(regions.region(neighbour))) continue;
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

bool is_paper(const Basin& region) { return distance_from_white(region) < paper_distance; }

int unite_background(RegionMerging& regions, Basins& basins) {
  const bool opaque = has_opaque_areas(regions);
  const auto picture_area = static_cast<int64_t>(basins.index.pixels.size());
  int background = -1;
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r)) continue;
    const Basin& region = regions.region(r);
    const bool outside = reaches_outside(regions, r, picture_area) ||
                         (opaque && is_transparent(region)) || basins.figure.said;
    if (!outside || is_in_figure(region)) continue;
    if (background < 0)
      background = r;
    else
      regions.unite(background, r);
  }
  background = add_page(regions, basins, background < 0 ? -1 : regions.region_of(background));
  if (background < 0) return background;
  background = add_surroundings(regions, basins, background);
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

}  // namespace relievo::understanding
