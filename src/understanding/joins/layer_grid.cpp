#include "understanding/joins/layer_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "kernel/image/distance_transform.h"
#include "kernel/image/outlines.h"

namespace relievo::understanding {
namespace {

/// A part is rooted in its middle, not at an end, where its root is nearer to that than this share
/// of its reach.
constexpr double off_end = 0.1;
constexpr int64_t least_common = 12;  ///< grid pixels that parts which overlap have in common

/// The mean of the pixels that a part has in common with another.
Point2 common_centre(const LayerGrid& grid, int part, int other) {
  Point2 sum;
  double n = 0;
  for_each_pixel(grid.masks[part], [&](int x, int y) {
    if (!grid.masks[other].has(x, y)) return;
    sum = sum + Point2{x + 0.5, y + 0.5};
    ++n;
  });
  return n > 0 ? 1 / n * sum : sum;
}

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

std::vector<double> distance_inside(const Mask& mask,
                                    const std::function<bool(int, int)>& is_source) {
  const int width = mask.inside.width;
  std::vector<double> distance(mask.inside.pixels.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  for_each_pixel(mask, [&](int x, int y) {
    if (!is_source(x, y)) return;
    const int at = mask_index(mask, x, y);
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

double share_from_root(const LayerGrid& grid, int part, int root, int other) {
  const Point2 from = common_centre(grid, part, root);
  double reach = 1;
  for_each_pixel(grid.masks[part], [&](int x, int y) {
    reach = std::max(reach, distance(from, {x + 0.5, y + 0.5}));
  });
  if (distance(from, common_centre(grid, part, part)) < off_end * reach) return 1;
  return distance(from, common_centre(grid, part, other)) / reach;
}

double thickness_at(const LayerGrid& grid, int part, int other) {
  const Mask& mask = grid.masks[part];
  Image8 outside(mask.inside.width + 2, mask.inside.height + 2, 1);
  Image8 common = outside;
  std::fill(outside.pixels.begin(), outside.pixels.end(), uint8_t{1});
  for_each_pixel(mask, [&](int x, int y) {
    outside.at(x - mask.left + 1, y - mask.top + 1) = 0;
    common.at(x - mask.left + 1, y - mask.top + 1) = grid.masks[other].has(x, y) ? 1 : 0;
  });
  const Image<int32_t> radius = squared_distance_to(outside);
  const Image<int32_t> away = squared_distance_to(common);
  int32_t largest = 0;
  for (size_t i = 0; i < radius.pixels.size(); ++i)
    if (away.pixels[i] <= radius.pixels[i]) largest = std::max(largest, radius.pixels[i]);
  return std::sqrt(static_cast<double>(largest));
}

}  // namespace relievo::understanding
