#include "understanding/areas/cut_necks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/outlines.h"
#include "kernel/image/watershed.h"
#include "understanding/areas/find_neck.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr double grid_diagonal = 400;  ///< figure's diagonal, cells
constexpr double least_limb = 0.015;   ///< least area of a limb, per figure
constexpr double beside_cut = 2.5;     ///< cells; nearer to a cut, pixels belong to its side
constexpr int most_cuts = 10;          ///< number of cuts in a drawing

/// A cut through a region. The limb lies to its left.
struct NeckCut {
  Point2 from;  ///< cells
  Point2 to;
  int region = 0;  ///< region that is cut, and is the rest afterwards
  int limb = 0;    ///< new region of the limb
};

double figure_diagonal(const Basins& basins) {
  Box2 box;
  for (size_t b = 0; b < basins.basins.size(); ++b)
    if (basins.region[b] != 0) box.add(basins.basins[b].box);
  return box.diagonal();
}

NeckGrid grid_of(const Basins& basins) {
  NeckGrid grid;
  grid.cell = std::max(1.0, figure_diagonal(basins) / grid_diagonal);
  const int w = static_cast<int>(std::ceil(basins.index.width / grid.cell));
  const int h = static_cast<int>(std::ceil(basins.index.height / grid.cell));
  grid.wall = Image8(w, h, 1);
  for (int y = 0; y < basins.index.height; ++y)
    for (int x = 0; x < basins.index.width; ++x)
      if (LineMap::is_wall(basins.barrier.at(x, y)))
        grid.wall.at(static_cast<int>(x / grid.cell), static_cast<int>(y / grid.cell)) = 1;
  grid.region = Image<int32_t>(w, h, 1);
  for (int v = 0; v < h; ++v)
    for (int u = 0; u < w; ++u) {
      const int x = std::min(static_cast<int>((u + 0.5) * grid.cell), basins.index.width - 1);
      const int y = std::min(static_cast<int>((v + 0.5) * grid.cell), basins.index.height - 1);
      grid.region.at(u, v) = basins.region[basins.index.at(x, y)];
    }
  return grid;
}

/// Gives a limb its own region on the grid. Cells of the old region that lines separate from both
/// sides go to the nearer side.
void divide(const Neck& neck, int region, int limb, NeckGrid& grid) {
  const Mask inside = fill_outline({neck.limb}, grid.region.width, grid.region.height);
  const Mask both = fill_outline({neck.whole}, grid.region.width, grid.region.height);
  Image<int32_t> side(grid.region.width, grid.region.height, 1);
  for_each_pixel(both, [&](int x, int y) {
    if (grid.region.at(x, y) == region) side.at(x, y) = inside.has(x, y) ? limb : region;
  });
  flood_from_seeds(Image8(side.width, side.height, 1), side);
  for (size_t i = 0; i < side.pixels.size(); ++i)
    if (grid.region.pixels[i] == region && side.pixels[i] == limb) grid.region.pixels[i] = limb;
}

/// Cuts one region until it has no neck any more. Round limbs are cut again, since heads have ears.
void cut_region(int region, double least_area, NeckGrid& grid, int& regions,
                std::vector<NeckCut>& cuts) {
  std::vector<int> left = {region};
  while (!left.empty() && cuts.size() < most_cuts) {
    const int next = left.back();
    const std::optional<Neck> neck = find_neck(grid, next, least_area);
    if (!neck) {
      left.pop_back();
      continue;
    }
    cuts.push_back({neck->limb.front(), neck->limb.back(), next, ++regions});
    divide(*neck, next, regions, grid);
    if (neck->round) left.push_back(regions);
  }
}

/// Returns the region of the nearest cell, up to two cells away, that `own` was divided into.
/// `origin`: [regions] the proposed region that each came from.
int region_near(Point2 p, int own, const NeckGrid& grid, const std::vector<int>& origin) {
  const int x = static_cast<int>(p.x);
  const int y = static_cast<int>(p.y);
  int nearest = own;
  int least = std::numeric_limits<int>::max();
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (dx * dx + dy * dy >= least || !grid.has(x + dx, y + dy)) continue;
      const int region = grid.region.at(x + dx, y + dy);
      if (origin[region] != own) continue;
      least = dx * dx + dy * dy;
      nearest = region;
    }
  return nearest;
}

/// Returns the region, after the cuts, of a point in a region `own` that was divided: that of its
/// cell, and close to a cut that of its side.
int region_after(Point2 p, int own, const NeckGrid& grid, const std::vector<int>& origin,
                 const std::vector<NeckCut>& cuts) {
  int region = region_near(p, own, grid, origin);
  for (const NeckCut& cut : cuts) {
    if (region != cut.region && region != cut.limb) continue;
    if (distance_to_segment(p, cut.from, cut.to) < beside_cut)
      region = cross(cut.to - cut.from, p - cut.from) < 0 ? cut.limb : cut.region;
  }
  return region;
}

}  // namespace

bool cut_necks(Basins& basins) {
  NeckGrid grid = grid_of(basins);
  double figure_area = 0;
  for (const int32_t region : grid.region.pixels) figure_area += region != 0 ? 1 : 0;
  std::vector<NeckCut> cuts;
  int regions = basins.region_count;
  for (int region = 1; region <= basins.region_count; ++region)
    cut_region(region, least_limb * figure_area, grid, regions, cuts);
  if (cuts.empty()) return false;
  std::vector<int> origin(static_cast<size_t>(regions) + 1);
  std::iota(origin.begin(), origin.end(), 0);
  std::vector<uint8_t> is_divided(origin.size(), 0);
  for (const NeckCut& cut : cuts) {
    origin[cut.limb] = origin[cut.region];
    is_divided[origin[cut.region]] = 1;
  }
  std::map<std::pair<int, int>, int> basin_of;  // by old basin and new region
  for (int y = 0; y < basins.index.height; ++y)
    for (int x = 0; x < basins.index.width; ++x) {
      int32_t& basin = basins.index.at(x, y);
      const int own = basins.region[basin];
      if (is_divided[own] == 0) continue;
      const Point2 p{(x + 0.5) / grid.cell, (y + 0.5) / grid.cell};
      const int region = region_after(p, own, grid, origin, cuts);
      if (region == own) continue;
      const auto next = static_cast<int>(basins.basins.size());
      const auto [found, fresh] = basin_of.insert({{basin, region}, next});
      if (fresh) {
        basins.basins.push_back(basins.basins[basin]);
        basins.region.push_back(region);
      }
      basin = found->second;
    }
  basins.region_count = regions;
  return true;
}

}  // namespace relievo::understanding
