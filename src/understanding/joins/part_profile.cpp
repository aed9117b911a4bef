#include "understanding/joins/part_profile.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/moments.h"
#include "kernel/image/distance_transform.h"

namespace relievo::understanding {
namespace {

constexpr double least_feature = 0.02;    ///< lower bound of feature_inflation
constexpr double least_backdrop = 0.15;   ///< of the figure's area, that a backdrop takes
constexpr double most_behind = 0.05;      ///< of the figure's area, that is seen behind a backdrop
constexpr double most_seen = 0.5;         ///< of a backdrop's area, that is seen
constexpr double most_thickness = 0.55;   ///< inradius of what is seen over that of the whole
constexpr double least_free_edge = 0.25;  ///< of the edge of what is seen, towards the background
constexpr double least_within = 0.7;      ///< of a part's area, for it to lie within a backdrop
constexpr double least_inner = 0.2;       ///< of a backdrop's area, that such a part takes

/// The share of the pixel sides around the inked pixels of a part that borders on the background.
double free_edge(const PartRegions& regions, int part) {
  const Mask& mask = regions.inked[part];
  const Image16& map = regions.inked_map;
  int64_t free = 0;
  int64_t sides = 0;
  const auto count = [&](int x, int y) {
    if (mask.has(x, y)) return;
    ++sides;
    const bool on_canvas = x >= 0 && y >= 0 && x < map.width && y < map.height;
    free += on_canvas && map.at(x, y) != 0 ? 0 : 1;
  };
  for_each_pixel(mask, [&](int x, int y) {
    count(x - 1, y);
    count(x + 1, y);
    count(x, y - 1);
    count(x, y + 1);
  });
  return sides > 0 ? static_cast<double>(free) / static_cast<double>(sides) : 0;
}

/// The largest distance from a pixel of a mask to one outside it, px.
double inradius(const Mask& mask) {
  Image8 outside(mask.inside.width + 2, mask.inside.height + 2, 1);
  std::fill(outside.pixels.begin(), outside.pixels.end(), uint8_t{1});
  for_each_pixel(mask, [&](int x, int y) { outside.at(x - mask.left + 1, y - mask.top + 1) = 0; });
  const Image<int32_t> squared = squared_distance_to(outside);
  return std::sqrt(
      static_cast<double>(*std::max_element(squared.pixels.begin(), squared.pixels.end())));
}

double size_of(const Mask& mask) { return static_cast<double>(pixel_count(mask)); }

bool is_backdrop(const PartRegions& regions, const Mask& mask, int part, double figure) {
  const double whole = size_of(mask);
  const Mask& seen = regions.inked[part];
  return whole >= least_backdrop * figure && size_of(seen) < most_seen * whole &&
         free_edge(regions, part) >= least_free_edge &&
         inradius(seen) < most_thickness * inradius(mask);
}

/// Whether a part of some size that lies within another grows out of it.
bool bears(const Completion& shapes, int part, const std::vector<ProposedJoin>& joins) {
  const Mask& mask = shapes[part].shape;
  const double whole = size_of(mask);
  return std::any_of(joins.begin(), joins.end(), [&](const ProposedJoin& proposed) {
    if (proposed.join.lower != part) return false;
    int64_t size = 0;
    int64_t within = 0;
    for_each_pixel(shapes[proposed.join.upper].shape, [&](int x, int y) {
      ++size;
      within += mask.has(x, y) ? 1 : 0;
    });
    const auto inner = static_cast<double>(size);
    return inner >= least_inner * whole && static_cast<double>(within) >= least_within * inner;
  });
}

}  // namespace

double feature_inflation(double share) {
  return std::max(0.4 * (1 - 1.5 * std::sqrt(share)), least_feature);
}

double round_inflation(const Mask& mask) {
  Moments moments;
  for_each_pixel(mask, [&](int x, int y) {
    moments.add({static_cast<double>(x - mask.left), static_cast<double>(y - mask.top)});
  });
  const MainAxes axes = moments.axes();
  return axes.longer > 0 ? 2 * (1 + axes.shorter / axes.longer) : 4;
}

std::vector<uint8_t> find_backdrops(const PartRegions& regions, const Completion& shapes,
                                    const std::vector<ProposedJoin>& joins) {
  double figure = 0;
  for (const Mask& seen : regions.inked) figure += size_of(seen);
  std::vector<uint8_t> backdrops(shapes.size(), 0);
  double behind = 0;
  for (int part = 0; part < regions.count() && behind <= most_behind * figure; ++part) {
    const bool is =
        is_backdrop(regions, shapes[part].shape, part, figure) && !bears(shapes, part, joins);
    backdrops[part] = is ? 1 : 0;
    behind += size_of(regions.inked[part]);
  }
  return backdrops;
}

}  // namespace relievo::understanding
