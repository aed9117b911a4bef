#include "understanding/joins/part_profile.h"

#include <algorithm>
#include <array>
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

using Rgb = std::array<double, 3>;

/// Open mouths: the least excess of red over green and blue, the largest brightness over the
/// face's, the least width over height, and the largest share of the face's area.
constexpr double least_red = 0.12;
constexpr double darkness = 0.65;
constexpr double mouth_width = 2;
constexpr double largest_mouth = 0.25;
/// Ear cups: the least excess of red over green, the largest difference between green and blue, and
/// bounds of the share of the ear's area. They are brighter than `darkness` times the ear.
constexpr double least_pink = 0.06;
constexpr double pink_range = 0.15;
constexpr double smallest_cup = 0.15;
constexpr double largest_cup = 0.7;

/// The luma of a colour (Rec. 709 weights).
double brightness(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

bool is_mouth(const Mask& mask, double share, const Rgb& own, const Rgb& face) {
  const double width = mask.inside.width;
  return own[0] > std::max(own[1], own[2]) + least_red &&
         brightness(own) < darkness * brightness(face) &&
         width > mouth_width * mask.inside.height && share < largest_mouth;
}

bool is_cup(double share, const Rgb& own, const Rgb& ear) {
  return own[0] > own[1] + least_pink && std::abs(own[1] - own[2]) < pink_range &&
         brightness(own) > darkness * brightness(ear) && share > smallest_cup &&
         share < largest_cup;
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

std::vector<int> hollow_parts(const LayerGrid& grid, const PartColors& colors,
                              const std::vector<uint8_t>& limb) {
  const int count = static_cast<int>(std::min(grid.masks.size(), colors.size()));
  const auto looks_hollow = [&](int upper, int lower) {
    if (colors[upper].empty() || colors[lower].empty()) return false;
    const auto own = static_cast<double>(grid.areas[upper]);
    if (static_cast<double>(common_area(grid, upper, lower)) < (1 - most_outside) * own)
      return false;
    const double share = own / static_cast<double>(grid.areas[lower]);
    const Rgb& color = colors[upper].front();
    return is_mouth(grid.masks[upper], share, color, colors[lower].front()) ||
           (limb[lower] != 0 && is_cup(share, color, colors[lower].front()));
  };
  std::vector<int> hollows;
  for (int upper = 1; upper < count; ++upper)
    for (int lower = 0; lower < upper; ++lower) {
      if (!looks_hollow(upper, lower)) continue;
      hollows.push_back(upper);
      break;
    }
  return hollows;
}

}  // namespace relievo::understanding
