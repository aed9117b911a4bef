#include "understanding/paper/cast_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

// Differences and channels are of 255.
constexpr int shadow_tint = 14;     ///< largest difference of a shadow's channels
constexpr int darkest_shadow = 80;  ///< least darkest channel of a shadow
constexpr int smooth_step = 4;      ///< largest difference of neighbouring pixels without an edge
constexpr double least_shadow = 0.002;  ///< least area of a shadow, per picture
constexpr int compression_noise = 12;   ///< deviation of the darkest channel beside edges
constexpr int half_leak = 3;            ///< px, half width at which shadow and figure are separated
constexpr double shadow_breadth = 1.5;  ///< least width of a shadow over its height
constexpr double end_share = 0.03;      ///< width of a shadow's ends, per its width
constexpr int deepest_rim = 8;          ///< px from the page to the outline that bounds a figure
constexpr double inked_share = 0.8;     ///< least share of the figure's rim that is inked

bool is_grey(const Image8& rgba, int x, int y) {
  const uint8_t* p = &rgba.at(x, y);
  const auto [darkest, brightest] = std::minmax({p[0], p[1], p[2]});
  return brightest - darkest <= shadow_tint && darkest >= darkest_shadow && darkest < palest_paint;
}

/// Returns 1 where grey is connected to white without an edge.
Image8 smoothly_reached(const Image8& rgba) {
  const int w = rgba.width;
  const auto visit_smooth = [&](int x, int y, const auto& visit) {
    const int own = darkest_channel(rgba, x, y);
    for (const auto& [u, v] : side_neighbours(x, y)) {
      if (u < 0 || v < 0 || u >= w || v >= rgba.height) continue;
      const int other = darkest_channel(rgba, u, v);
      if (std::abs(other - own) <= smooth_step) visit(u, v, other);
    }
  };
  Image8 reached(w, rgba.height, 1);
  std::vector<int> open;
  const auto take = [&](int x, int y) {
    if (reached.at(x, y) != 0 || !is_grey(rgba, x, y)) return;
    reached.at(x, y) = 1;
    open.push_back(y * w + x);
  };
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < w; ++x)
      if (is_grey(rgba, x, y))
        visit_smooth(x, y, [&](int, int, int other) {
          if (other >= palest_paint) take(x, y);
        });
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    visit_smooth(i % w, i / w, [&](int u, int v, int) { take(u, v); });
  }
  return reached;
}

/// A connected piece of grey.
struct GreyPiece {
  Box2 box;             ///< px
  double mean = 0;      ///< mean of the darkest channel
  int64_t to_page = 0;  ///< pairs of its pixels with white neighbours
  int64_t to_rest = 0;  ///< pairs with neighbours of other colours
};

/// The connected pieces of grey pixels.
struct GreyPieces {
  Components pieces;
  std::vector<GreyPiece> measured;  ///< [pieces + 1]
};

GreyPieces find_pieces_of(const Image8& grey, const Image8& rgba) {
  GreyPieces found{connected_components(grey, Connectivity::sides), {}};
  const Components& pieces = found.pieces;
  std::vector<GreyPiece>& measured = found.measured;
  measured.resize(pieces.areas.size());
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      const int32_t piece = pieces.label.at(x, y);
      if (piece == 0) continue;
      measured[piece].box.add(Point2{x + 0.5, y + 0.5});
      measured[piece].mean += static_cast<double>(darkest_channel(rgba, x, y)) /
                              static_cast<double>(pieces.areas[piece]);
      for (const auto& [u, v] : side_neighbours(x, y)) {
        if (pieces.label.at(u, v) == piece) continue;
        const bool page = darkest_channel(rgba, u, v) >= palest_paint;
        ++(page ? measured[piece].to_page : measured[piece].to_rest);
      }
    }
  return found;
}

/// Returns whether a piece lies as a shadow does: it is broad, and below the row `middle`.
bool lies_below(const GreyPieces& grey, size_t piece, double middle) {
  const Box2& box = grey.measured[piece].box;
  const double share = static_cast<double>(grey.pieces.areas[piece]) /
                       static_cast<double>(grey.pieces.label.pixels.size());
  return share > least_shadow && box.min.y > middle &&
         box.max.x - box.min.x > shadow_breadth * (box.max.y - box.min.y);
}

/// Finds soft shadows, 1 in the result: grey pieces that lie as one does and are bounded by the
/// page for the most part. Grey areas of the figure that touch them are cut off at narrow places.
Image8 soft_shadow(const Image8& grey, const Image8& rgba, double middle) {
  const GreyPieces found = find_pieces_of(remove_specks(grey, half_leak), rgba);
  std::vector<uint8_t> lies(found.measured.size(), 0);
  for (size_t k = 1; k < lies.size(); ++k)
    lies[k] = found.measured[k].to_page > found.measured[k].to_rest && lies_below(found, k, middle);
  Image8 result(grey.width, grey.height, 1);
  for (size_t i = 0; i < grey.pixels.size(); ++i)
    result.pixels[i] = lies[found.pieces.label.pixels[i]];
  result = max_filter(result, half_leak);
  for (size_t i = 0; i < grey.pixels.size(); ++i) result.pixels[i] &= grey.pixels[i];
  return result;
}

/// Finds the grey pixels inside the picture that have no edge to a neighbour.
Image8 flat_grey(const Image8& rgba) {
  Image8 flat(rgba.width, rgba.height, 1);
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      if (!is_grey(rgba, x, y)) continue;
      const int own = darkest_channel(rgba, x, y);
      const auto sides = side_neighbours(x, y);
      flat.at(x, y) = std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        return std::abs(darkest_channel(rgba, side.first, side.second) - own) <= smooth_step;
      });
    }
  return flat;
}

/// Computes the share of the figure's rim that is inked: along the page's border, whether ink comes
/// before flat grey or neither. Pieces that may be the shadow are left out.
double inked_share_of_rim(const GreyPieces& grey, const std::vector<int32_t>& shadows,
                          const Image8& tinted, const Image8& rgba) {
  const Components open = connected_components(complement(tinted), Connectivity::sides);
  const std::vector<uint8_t> is_page = pieces_at_edge(open);
  double inked = 0;
  double all = 0;
  const auto look = [&](int x, int y, int step_x, int step_y) {
    int32_t piece = 0;
    bool ink = false;
    for (int k = 0; k < deepest_rim && piece == 0 && !ink; ++k, x += step_x, y += step_y) {
      if (x < 0 || y < 0 || x >= rgba.width || y >= rgba.height) break;
      piece = grey.pieces.label.at(x, y);
      ink = piece == 0 && is_dark(&rgba.at(x, y));
    }
    if (std::find(shadows.begin(), shadows.end(), piece) != shadows.end()) return;
    inked += ink ? 1 : 0;
    ++all;
  };
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      if (is_page[open.label.at(x, y)] == 0) continue;
      for (const auto& [u, v] : side_neighbours(x, y))
        if (open.label.at(u, v) == 0) look(u, v, u - x, v - y);
    }
  return all > 0 ? inked / all : 1;
}

/// Returns whether a pixel is grey and not darker than a shadow of that mean.
bool is_like(const Image8& rgba, int x, int y, double mean) {
  return is_grey(rgba, x, y) && darkest_channel(rgba, x, y) >= mean - compression_noise;
}

/// Returns whether the page lies above and below a piece at its left and right end.
bool has_open_ends(const GreyPieces& grey, int32_t piece, const Image8& rgba) {
  const Box2& box = grey.measured[piece].box;
  const auto reaches_page = [&](int x, int y, int step) {
    while (y >= 0 && y < rgba.height && is_like(rgba, x, y, grey.measured[piece].mean)) y += step;
    return y < 0 || y >= rgba.height || darkest_channel(rgba, x, y) >= palest_paint;
  };
  const int left = static_cast<int>(box.min.x);
  const int right = static_cast<int>(box.max.x);
  const int reach = static_cast<int>(end_share * (right - left));
  for (int y = static_cast<int>(box.min.y); y < box.max.y; ++y)
    for (int x = left; x <= right; x = x == left + reach ? right - reach : x + 1) {
      const bool is_end = grey.pieces.label.at(x, y) == piece;
      if (is_end && !(reaches_page(x, y, -1) && reaches_page(x, y, 1))) return false;
    }
  return true;
}

/// Returns 1 on the pieces of a piece's grey inside its convex hull, and on the pixels between them
/// and the page that are grey and not darker.
Image8 whole_shadow(const GreyPieces& grey, int32_t piece, const Image8& rgba) {
  std::vector<Point2> pixels;
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x)
      if (grey.pieces.label.at(x, y) == piece) pixels.push_back({x + 0.5, y + 0.5});
  const Mask hull = fill_outline({convex_hull(std::move(pixels))}, rgba.width, rgba.height);
  Image8 pieces(rgba.width, rgba.height, 1);
  for_each_pixel(hull, [&](int x, int y) {
    const int32_t other = grey.pieces.label.at(x, y);
    const bool like = other != 0 && std::abs(grey.measured[other].mean -
                                             grey.measured[piece].mean) <= smooth_step;
    pieces.at(x, y) = like ? 1 : 0;
  });
  Image8 all = max_filter(pieces, half_leak);
  for (int y = 0; y < rgba.height; ++y)
    for (int x = 0; x < rgba.width; ++x)
      if (!is_like(rgba, x, y, grey.measured[piece].mean)) all.at(x, y) = pieces.at(x, y);
  return all;
}

/// Finds a shadow with a hard edge, 1 in the result: one grey, without an outline, below a figure
/// with inked outlines. Empty where there is none.
Image8 hard_shadow(const Image8& rgba, const Image8& tinted, double middle) {
  const GreyPieces grey = find_pieces_of(flat_grey(rgba), rgba);
  std::vector<int32_t> lying;
  for (int32_t k = 1; k < static_cast<int32_t>(grey.measured.size()); ++k)
    if (lies_below(grey, k, middle) && has_open_ends(grey, k, rgba)) lying.push_back(k);
  if (lying.empty() || inked_share_of_rim(grey, lying, tinted, rgba) < inked_share) return {};
  const int32_t largest = *std::max_element(lying.begin(), lying.end(), [&](int32_t a, int32_t b) {
    return grey.pieces.areas[a] < grey.pieces.areas[b];
  });
  return whole_shadow(grey, largest, rgba);
}

}  // namespace

Image8 without_cast_shadow(const Image8& rgba) {
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i] < 128) return {};
  const Image8 tinted = tinted_pixels(rgba);
  const Box2 figure = box_of(tinted);
  const double middle = (figure.min.y + figure.max.y - 1) / 2;
  Image8 shadow = soft_shadow(smoothly_reached(rgba), rgba, middle);
  if (pixel_count(shadow) == 0) {
    shadow = hard_shadow(rgba, tinted, middle);
    if (shadow.empty()) return {};
  }
  Image8 lit = rgba;
  for (size_t i = 0; i < shadow.pixels.size(); ++i)
    if (shadow.pixels[i] != 0) std::fill_n(&lit.pixels[4 * i], 3, uint8_t{255});
  return lit;
}

}  // namespace relievo::understanding
