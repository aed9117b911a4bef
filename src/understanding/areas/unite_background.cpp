#include "understanding/areas/unite_background.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "understanding/figure/figure_mask.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/page.h"

namespace relievo::understanding {
namespace {

// Distances of colours are of 255 a channel.
constexpr double page_share = 0.35;         ///< least area of a page, per picture
constexpr double least_page_overlap = 0.8;  ///< least page_overlap of a page
constexpr double paper_distance = 70;       ///< distance from white below which a region is paper
constexpr double cut_figure_share =
    0.12;                                ///< least area of a figure that one edge cuts, per picture
constexpr double cut_share = 0.12;       ///< largest share of its rim that the border cuts
constexpr double cut_line_share = 0.8;   ///< least share of the rest of its rim that is lined
constexpr double open_page_share = 0.3;  ///< largest share of the border that a page reaches
constexpr double opaque_share = 0.05;    ///< least opaque share of a drawing with fills
constexpr double spread_distance = 45;   ///< largest distance of colours across which it spreads
constexpr double leak_width = 0.7;   ///< least width of a gap that it spreads through, per inradius
constexpr double leak_share = 0.07;  ///< least open share of a border that it spreads through

int64_t pixels_at_edge(const Basin& region) {
  return std::accumulate(region.at_edge.begin(), region.at_edge.end(), int64_t{0});
}

/// Returns whether lines bound all of a region except a little that the picture's border cuts off:
/// it is a hand, for example, and not the paper beside it.
bool is_cut_off(const RegionMerging& regions, int r) {
  const int64_t at_edge = pixels_at_edge(regions.region(r));
  const Border rest = regions.whole_border(r);
  return static_cast<double>(at_edge) < cut_share * static_cast<double>(at_edge + rest.pairs) &&
         static_cast<double>(rest.line_pairs) > cut_line_share * static_cast<double>(rest.pairs);
}

/// Returns whether a region is paper that reaches the picture's border and is no figure.
bool reaches_outside(const RegionMerging& regions, int r, int64_t picture_area) {
  const Basin& region = regions.region(r);
  const auto edges = std::count_if(region.at_edge.begin(), region.at_edge.end(),
                                   [](int64_t pixels) { return pixels > 0; });
  if (edges == 0 || !is_paper(region)) return false;
  if (edges > 1) return true;
  return static_cast<double>(region.area) < cut_figure_share * static_cast<double>(picture_area) &&
         !is_cut_off(regions, r);
}

/// Unites with the background what lies around the page of a photograph. Returns the background.
int add_surroundings(RegionMerging& regions, const Basins& basins, int background) {
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r) || r == background || is_in_figure(regions.region(r))) continue;
    const Basin& region = regions.region(r);
    if (is_around_page(region.at_edge, region.area, basins.index.width, basins.index.height))
      background = regions.unite(background, r);
  }
  return background;
}

/// Returns 1 on the region `paper` and on all that it surrounds, if that is a page: a large
/// quadrilateral with hardly any paper around it. Else empty.
Image8 find_page(RegionMerging& regions, const Basins& basins, int paper) {
  const Image8 page =
      without_holes(mask_where(basins.index.width, basins.index.height, [&](size_t i) {
        return regions.region_of(basins.index.pixels[i]) == paper;
      }));
  const int64_t area = pixel_count(page);
  const auto all = static_cast<int64_t>(page.pixels.size());
  if (static_cast<double>(area) < page_share * static_cast<double>(all) ||
      page_overlap(page) < least_page_overlap)
    return {};
  int64_t paper_around = 0;
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (page.pixels[i] == 0)
      paper_around += is_paper(regions.region(regions.region_of(basins.index.pixels[i]))) ? 1 : 0;
  return 2 * paper_around < all - area ? page : Image8{};
}

/// Unites everything around the page with the background and removes the lines there. Returns the
/// background.
int unite_around_page(RegionMerging& regions, Basins& basins, const Image8& page, int background) {
  std::vector<int64_t> around(regions.count(), 0);
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (page.pixels[i] == 0) ++around[regions.region_of(basins.index.pixels[i])];
  for (int r = 0; r < regions.count(); ++r)
    if (r != background && regions.is_region(r) && 2 * around[r] > regions.region(r).area)
      background = regions.unite(background, r);
  const Image8 within = min_filter(page, static_cast<int>(basins.line_width) + 1);
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (within.pixels[i] == 0) {
      basins.barrier.pixels[i] = LineMap::none;
      basins.ink.pixels[i] = 0;
    }
  return background;
}

/// Unites the page and everything around it with the background where the largest region of paper
/// is a page. Returns the background, or -1 where there is none.
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
  if (background < 0 || background == paper)
    background = paper;
  else
    background = regions.unite(background, paper);
  return unite_around_page(regions, basins, page, background);
}

/// Returns whether the drawing has transparent and opaque areas, so that the transparent ones are
/// background.
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

/// Returns the neighbour that is most open to the background, which therefore belongs to it, or -1.
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

bool is_paper(const Basin& region) {
  if (region.coloured == 0) return true;
  const std::array<double, 3> mean = mean_colour(region);
  return 255 - *std::min_element(mean.begin(), mean.end()) < paper_distance;
}

int unite_background(RegionMerging& regions, Basins& basins) {
  const bool opaque = has_opaque_areas(regions);
  const auto picture_area = static_cast<int64_t>(basins.index.pixels.size());
  int background = -1;
  for (int r = 0; r < regions.count(); ++r) {
    if (!regions.is_region(r)) continue;
    const Basin& region = regions.region(r);
    const bool outside = reaches_outside(regions, r, picture_area) ||
                         (opaque && is_transparent(region)) || basins.figure.cut_out;
    if (outside && !is_in_figure(region))
      background = background < 0 ? r : regions.unite(background, r);
  }
  background = add_page(regions, basins, background);
  if (background < 0) return background;
  background = add_surroundings(regions, basins, background);
  for (int r = leaking_neighbour(regions, background); r >= 0;
       r = leaking_neighbour(regions, background))
    background = regions.unite(background, r);
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
