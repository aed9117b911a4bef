#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/morphology.h"
#include "relief/drawing/figure_mask.h"
#include "relief/drawing/line_map.h"

namespace relievo {
namespace {

constexpr double page_share = 0.35;  ///< of the picture, at least
constexpr double quad_share = 0.88;  ///< of a page, which the area between its corners has at least

/// A region with all that it surrounds.
Image8 filled(RegionMerging& regions, const Basins& basins, int r) {
  Image8 mask(basins.index.width, basins.index.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = regions.region_of(basins.index.pixels[i]) == r ? 1 : 0;
  return without_holes(mask);
}

/// The pixel of a mask that lies farthest by some measure of its place.
template <class Measure>
Point2 farthest(const Image8& mask, Measure measure) {
  Point2 best;
  double most = -1;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0) continue;
      const Point2 p{x + 0.5, y + 0.5};
      const double value = measure(p);
      if (value <= most) continue;
      most = value;
      best = p;
    }
  return best;
}

/// Area between two opposite corners of a mask and what lies farthest off their line at either
/// side, px^2: all of a page, however it is turned and seen aslant, and 0.64 of an ellipse.
double area_between_corners(const Image8& mask) {
  Point2 sum;
  double count = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0) {
        sum.x += x + 0.5;
        sum.y += y + 0.5;
        ++count;
      }
  const Point2 centre{sum.x / count, sum.y / count};
  const Point2 a = farthest(mask, [&](Point2 p) { return distance(p, centre); });
  const Point2 b = farthest(mask, [&](Point2 p) { return distance(p, a); });
  const auto side = [&](Point2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
  const Point2 left = farthest(mask, side);
  const Point2 right = farthest(mask, [&](Point2 p) { return -side(p); });
  return (side(left) - side(right)) / 2;
}

}  // namespace

Image8 find_page(RegionMerging& regions, const Basins& basins, int paper) {
  const Image8 page = filled(regions, basins, paper);
  const auto area = std::count(page.pixels.begin(), page.pixels.end(), 1);
  if (static_cast<double>(area) < page_share * static_cast<double>(page.pixels.size()) ||
      area_between_corners(page) < quad_share * static_cast<double>(area))
    return {};
  int64_t paper_around = 0;
  for (size_t i = 0; i < page.pixels.size(); ++i)
    if (page.pixels[i] == 0)
      paper_around += is_paper(regions.region(regions.region_of(basins.index.pixels[i]))) ? 1 : 0;
  return 2 * paper_around < static_cast<int64_t>(page.pixels.size()) - area ? page : Image8{};
}

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

}  // namespace relievo
