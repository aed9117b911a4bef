#include "relief/join_proposals/part_profile.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/moments.h"
#include "kernel/geometry/polygon.h"
#include "kernel/image/filters.h"

namespace relievo {
namespace {

constexpr double least_feature = 0.02;
constexpr double least_backdrop = 0.15;   ///< of the figure
constexpr double most_behind = 0.05;      ///< of the figure, seen of what lies behind a backdrop
constexpr double most_seen = 0.5;         ///< of a backdrop
constexpr double most_thickness = 0.55;   ///< inradius of what is seen of it over its own
constexpr double least_free_edge = 0.25;  ///< of what is seen, towards the background
constexpr double least_within = 0.7;      ///< of a part, for it to lie within a backdrop
constexpr double least_inner = 0.2;       ///< of a backdrop, of a part in it that has some size

/// Which part is seen at each pixel of the figure's box.
struct Seen {
  int left = 0;
  int top = 0;
  Image<int32_t> part;  ///< -1 where there is none
  std::vector<int64_t> pixels;
  int64_t figure = 0;

  int at(int x, int y) const {
    const int column = x - left;
    const int row = y - top;
    const bool inside = column >= 0 && row >= 0 && column < part.width && row < part.height;
    return inside ? part.at(column, row) : -1;
  }
};

Seen see(const Completion& shapes, const std::vector<int>& back_to_front) {
  Box2 box;
  for (const CompletedPart& part : shapes.parts) {
    box.add(Point2{static_cast<double>(part.shape.left), static_cast<double>(part.shape.top)});
    box.add(
        Point2{static_cast<double>(part.shape.right()), static_cast<double>(part.shape.bottom())});
  }
  Seen seen;
  seen.left = static_cast<int>(box.min.x);
  seen.top = static_cast<int>(box.min.y);
  seen.part = Image<int32_t>(static_cast<int>(box.max.x) - seen.left,
                             static_cast<int>(box.max.y) - seen.top, 1);
  std::fill(seen.part.pixels.begin(), seen.part.pixels.end(), -1);
  for (const int part : back_to_front)
    for_each_pixel(shapes.parts[part].shape,
                   [&](int x, int y) { seen.part.at(x - seen.left, y - seen.top) = part; });
  seen.pixels.resize(back_to_front.size());
  for (const int32_t part : seen.part.pixels)
    if (part >= 0) {
      ++seen.pixels[part];
      ++seen.figure;
    }
  return seen;
}

/// Share of the pixel sides around what is seen of a part that are towards the background.
double free_edge(const Seen& seen, const Mask& mask, int part) {
  double free = 0;
  double sides = 0;
  for_each_pixel(mask, [&](int x, int y) {
    if (seen.at(x, y) != part) return;
    for (const int beside :
         {seen.at(x - 1, y), seen.at(x + 1, y), seen.at(x, y - 1), seen.at(x, y + 1)}) {
      free += beside < 0 ? 1 : 0;
      sides += beside != part ? 1 : 0;
    }
  });
  return sides > 0 ? free / sides : 0;
}

/// The largest distance from one of the pixels of a mask for which `is_inside` holds to one for
/// which it does not, px.
template <class Inside>
double inradius(const Mask& mask, Inside is_inside) {
  Image8 outside(mask.inside.width + 2, mask.inside.height + 2, 1);
  std::fill(outside.pixels.begin(), outside.pixels.end(), uint8_t{1});
  for_each_pixel(mask, [&](int x, int y) {
    if (is_inside(x, y)) outside.at(x - mask.left + 1, y - mask.top + 1) = 0;
  });
  const Image<int32_t> squared = squared_distance_to(outside);
  return std::sqrt(
      static_cast<double>(*std::max_element(squared.pixels.begin(), squared.pixels.end())));
}

bool is_backdrop(const Seen& seen, const Mask& mask, int part) {
  const auto figure = static_cast<double>(seen.figure);
  const auto whole = static_cast<double>(pixel_count(mask));
  if (whole < least_backdrop * figure) return false;
  if (static_cast<double>(seen.pixels[part]) >= most_seen * whole) return false;
  if (free_edge(seen, mask, part) < least_free_edge) return false;
  const double strips = inradius(mask, [&](int x, int y) { return seen.at(x, y) == part; });
  return strips < most_thickness * inradius(
                                       mask, [](int, int) { return true; });
}

/// Whether something of some size that lies within a part grows out of it.
bool bears(const Completion& shapes, int part, const std::vector<ProposedJoin>& joins) {
  const Mask& mask = shapes.parts[part].shape;
  const auto whole = static_cast<double>(pixel_count(mask));
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

std::vector<uint8_t> find_backdrops(const Completion& shapes, const Stacking& stacking,
                                    const std::vector<ProposedJoin>& joins) {
  if (shapes.parts.empty()) return {};
  const Seen seen = see(shapes, stacking.back_to_front);
  std::vector<uint8_t> backdrops(shapes.parts.size(), 0);
  int64_t behind = 0;
  for (const int part : stacking.back_to_front) {
    if (static_cast<double>(behind) > most_behind * static_cast<double>(seen.figure)) break;
    const bool is =
        is_backdrop(seen, shapes.parts[part].shape, part) && !bears(shapes, part, joins);
    backdrops[part] = is ? 1 : 0;
    behind += seen.pixels[part];
  }
  return backdrops;
}

}  // namespace relievo
