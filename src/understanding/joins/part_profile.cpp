#include "understanding/joins/part_profile.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/moments.h"
#include "kernel/image/distance_transform.h"

namespace relievo::understanding {
namespace {

constexpr double least_feature = 0.02;
constexpr double least_backdrop = 0.15;   ///< of the figure
constexpr double most_behind = 0.05;      ///< of the figure, seen of what lies behind a backdrop
constexpr double most_seen = 0.5;         ///< of a backdrop
constexpr double most_thickness = 0.55;   ///< inradius of what is seen of it over its own
constexpr double least_free_edge = 0.25;  ///< of what is seen, towards the background
constexpr double least_within = 0.7;      ///< of a part, for it to lie within a backdrop
constexpr double least_inner = 0.2;       ///< of a backdrop, of a part in it that has some size

/// Share of the pixel sides around what is seen of a part that are towards the background.
double free_edge(const PartRegions& regions, int part) {
  double free = 0;
  double sides = 0;
  for (const LabelRing& ring : regions.rings[part]) {
    free += static_cast<double>(std::count(ring.beyond.begin(), ring.beyond.end(), 0));
    sides += static_cast<double>(ring.size());
  }
  return sides > 0 ? free / sides : 0;
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
  const Mask& seen = regions.visible[part];
  return whole >= least_backdrop * figure && size_of(seen) < most_seen * whole &&
         free_edge(regions, part) >= least_free_edge &&
         inradius(seen) < most_thickness * inradius(mask);
}

/// Whether something of some size that lies within a part grows out of it.
bool bears(const Completion& shapes, int part, const std::vector<ProposedJoin>& joins) {
  const Mask& mask = shapes.parts[part].shape;
  const double whole = size_of(mask);
  return std::any_of(joins.begin(), joins.end(), [&](const ProposedJoin& proposed) {
    if (proposed.join.lower != part) return false;
    int64_t size = 0;
    int64_t within = 0;
    for_each_pixel(shapes.parts[proposed.join.upper].shape, [&](int x, int y) {
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

std::vector<uint8_t> find_backdrops(const PartRegions& regions, const Stacking& stacking,
                                    const Completion& shapes,
                                    const std::vector<ProposedJoin>& joins) {
  double figure = 0;
  for (const Mask& seen : regions.visible) figure += size_of(seen);
  std::vector<uint8_t> backdrops(shapes.parts.size(), 0);
  double behind = 0;
  for (const int part : stacking.back_to_front) {
    if (behind > most_behind * figure) break;
    const bool is =
        is_backdrop(regions, shapes.parts[part].shape, part, figure) && !bears(shapes, part, joins);
    backdrops[part] = is ? 1 : 0;
    behind += size_of(regions.visible[part]);
  }
  return backdrops;
}

}  // namespace relievo::understanding
