#include "understanding/joins/hollow_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo::understanding {
namespace {

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
