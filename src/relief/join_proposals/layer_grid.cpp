#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "kernel/image/outlines.h"
#include "relief/join_proposals/roots.h"

namespace relievo {
namespace {

constexpr int64_t least_common = 12;  ///< grid pixels that two parts share, else they do not meet

}  // namespace

bool LayerGrid::has(int part, Point2 p) const {
  return masks[part].has(static_cast<int>(std::floor(p.x * scale)),
                         static_cast<int>(std::floor(p.y * scale)));
}

LayerGrid make_layer_grid(const Scene& scene, int side) {
  LayerGrid grid;
  grid.scale = side / std::max(scene.width, scene.height);
  const int width = static_cast<int>(std::ceil(scene.width * grid.scale));
  const int height = static_cast<int>(std::ceil(scene.height * grid.scale));
  for (const Part& part : scene.parts) {
    Outline outline = part.outline;
    for (Ring& ring : outline)
      for (Point2& p : ring) p = grid.scale * p;
    grid.masks.push_back(fill_outline(outline, width, height));
    grid.areas.push_back(pixel_count(grid.masks.back()));
  }
  return grid;
}

int64_t common_area(const LayerGrid& grid, int a, int b) {
  const Mask& p = grid.masks[a];
  const Mask& q = grid.masks[b];
  int64_t common = 0;
  for (int y = std::max(p.top, q.top); y < std::min(p.bottom(), q.bottom()); ++y)
    for (int x = std::max(p.left, q.left); x < std::min(p.right(), q.right()); ++x)
      common += p.has(x, y) && q.has(x, y) ? 1 : 0;
  return common;
}

std::vector<double> distance_from_free_end(const LayerGrid& grid, int part, int other) {
  const Mask& mask = grid.masks[part];
  const int width = mask.inside.width;
  std::vector<double> distance(mask.inside.pixels.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for_each_pixel(mask, [&](int x, int y) {
    if (grid.masks[other].has(x, y)) return;
    const int at = (y - mask.top) * width + x - mask.left;
    distance[at] = 0;
    front.emplace(0, at);
  });
  while (!front.empty()) {
    const auto [reached, at] = front.top();
    front.pop();
    if (reached > distance[at]) continue;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (!mask.has(mask.left + at % width + dx, mask.top + at / width + dy)) continue;
        const int next = at + dy * width + dx;
        const double length = reached + std::hypot(dx, dy);
        if (length >= distance[next]) continue;
        distance[next] = length;
        front.emplace(length, next);
      }
  }
  return distance;
}

std::vector<Overlap> find_overlaps(const LayerGrid& grid) {
  std::vector<Overlap> overlaps;
  for (int upper = 1; upper < static_cast<int>(grid.masks.size()); ++upper)
    for (int lower = 0; lower < upper; ++lower) {
      const int64_t common = common_area(grid, upper, lower);
      if (common < least_common) continue;
      const auto beside = [&](int part) {
        return 1 - static_cast<double>(common) / static_cast<double>(grid.areas[part]);
      };
      overlaps.push_back({upper, lower, beside(upper), beside(lower)});
    }
  return overlaps;
}

}  // namespace relievo
