#include "understanding/paper/cast_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/components.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

constexpr int shadow_tint = 14;         ///< difference of channels of a shadow at most
constexpr int darkest_shadow = 80;      ///< darkest channel of one at least
constexpr int smooth_step = 4;          ///< between neighbouring pixels of one at most
constexpr double least_shadow = 0.002;  ///< of the picture
constexpr int codec_noise = 12;         ///< of a channel, beside its edge
constexpr int half_leak = 3;            ///< px
constexpr double shadow_breadth = 1.5;  ///< of a shadow, in its heights
constexpr double end_share = 0.03;      ///< of its breadth, that is looked at at its ends
constexpr int deepest_rim = 8;          ///< px from the page to what bounds it
constexpr double inked_share = 0.8;     ///< of what the page meets besides a hard shadow, at least

bool is_grey(const Image8& rgba, int x, int y) {
  const uint8_t* p = &rgba.at(x, y);
  const auto [darkest, brightest] = std::minmax({p[0], p[1], p[2]});
  return brightest - darkest <= shadow_tint && darkest >= darkest_shadow && darkest < palest;
}

/// 1 where one gets from white into grey, and on in it, without a step.
Image8 smoothly_reached(const Image8& rgba) {
  const int w = rgba.width;
  const auto visit_smooth = [&](int x, int y, const auto& visit) {
    const int own = darkest_channel(rgba, x, y);
    for (const auto& [u, v] : sides_of(x, y)) {
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
          if (other >= palest) take(x, y);
        });
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    visit_smooth(i % w, i / w, [&](int u, int v, int) { take(u, v); });
  }
  return reached;
}

/// What a piece of grey is like.
struct GreyPiece {
  Box2 box;
  double mean = 0;      ///< of the darkest channel
  int64_t to_page = 0;  ///< pairs of its pixels with white ones
  int64_t to_rest = 0;  ///< pairs with others that are not its own
};

/// [pieces + 1]
std::vector<GreyPiece> measure_pieces(const Components& pieces, const Image8& rgba) {
  std::vector<GreyPiece> measured(pieces.areas.size());
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      const int32_t piece = pieces.label.at(x, y);
      if (piece == 0) continue;
      measured[piece].box.add(Point2{x + 0.5, y + 0.5});
      measured[piece].mean += static_cast<double>(darkest_channel(rgba, x, y)) /
                              static_cast<double>(pieces.areas[piece]);
      for (const auto& [u, v] : sides_of(x, y)) {
        if (pieces.label.at(u, v) == piece) continue;
        const bool page = darkest_channel(rgba, u, v) >= palest;
        ++(page ? measured[piece].to_page : measured[piece].to_rest);
      }
    }
  return measured;
}

double share_of(const Components& pieces, size_t piece) {
  return static_cast<double>(pieces.areas[piece]) / static_cast<double>(pieces.label.pixels.size());
}

/// Whether a piece of that share of the picture lies as a shadow does: broad, in the lower half of
/// the figure.
bool lies_below(const Box2& box, double share, double middle) {
  return share > least_shadow && box.min.y > middle &&
         box.max.x - box.min.x > shadow_breadth * (box.max.y - box.min.y);
}

/// Soft shadows: of the grey that is reached, what lies as one does and is bounded by the page.
/// What it touches of the figure in the same grey is cut off where that is narrow.
Image8 lying_pieces(const Image8& grey, const Image8& rgba, double middle) {
  const Components pieces =
      connected_components(remove_specks(grey, half_leak), Connectivity::sides);
  const std::vector<GreyPiece> measured = measure_pieces(pieces, rgba);
  std::vector<uint8_t> lies(measured.size(), 0);
  for (size_t k = 1; k < measured.size(); ++k) {
    const GreyPiece& piece = measured[k];
    lies[k] = piece.to_page > piece.to_rest && lies_below(piece.box, share_of(pieces, k), middle);
  }
  Image8 result(grey.width, grey.height, 1);
  for (size_t i = 0; i < grey.pixels.size(); ++i) result.pixels[i] = lies[pieces.label.pixels[i]];
  result = max_filter(result, half_leak);
  for (size_t i = 0; i < grey.pixels.size(); ++i) result.pixels[i] &= grey.pixels[i];
  return result;
}

/// Grey without steps, in pieces.
struct FlatGrey {
  Components pieces;
  std::vector<GreyPiece> measured;  ///< [pieces + 1]
};

FlatGrey flat_grey(const Image8& rgba) {
  Image8 flat(rgba.width, rgba.height, 1);
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      if (!is_grey(rgba, x, y)) continue;
      const int own = darkest_channel(rgba, x, y);
      const auto sides = sides_of(x, y);
      flat.at(x, y) = std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        return std::abs(darkest_channel(rgba, side.first, side.second) - own) <= smooth_step;
      });
    }
  Components pieces = connected_components(flat, Connectivity::sides);
  std::vector<GreyPiece> measured = measure_pieces(pieces, rgba);
  return {std::move(pieces), std::move(measured)};
}

/// What the page meets of a picture.
struct PageContacts {
  std::vector<int64_t> grey;  ///< [pieces + 1] px of its rim where a piece of grey lies
  int64_t ink = 0;            ///< where ink runs
  int64_t bare = 0;           ///< where neither does
};

PageContacts find_contacts(const FlatGrey& grey, const Image8& tinted, const Image8& rgba) {
  const Components open = connected_components(complement(tinted), Connectivity::sides);
  const std::vector<uint8_t> is_page = pieces_at_edge(open);
  PageContacts contacts{std::vector<int64_t>(grey.measured.size()), 0, 0};
  const auto meet = [&](int x, int y, int step_x, int step_y) {
    for (int k = 0; k < deepest_rim; ++k, x += step_x, y += step_y) {
      if (x < 0 || y < 0 || x >= rgba.width || y >= rgba.height) break;
      const int32_t piece = grey.pieces.label.at(x, y);
      if (piece != 0) return ++contacts.grey[piece];
      if (is_dark(&rgba.at(x, y))) return ++contacts.ink;
    }
    return ++contacts.bare;
  };
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      if (is_page[open.label.at(x, y)] == 0) continue;
      for (const auto& [u, v] : sides_of(x, y))
        if (open.label.at(u, v) == 0) meet(u, v, u - x, v - y);
    }
  return contacts;
}

/// Grey of a shadow, or between that and the page.
bool is_like(const Image8& rgba, int x, int y, double mean) {
  return is_grey(rgba, x, y) && darkest_channel(rgba, x, y) >= mean - codec_noise;
}

/// Whether a piece ends openly to its left and right: page above and below.
bool has_open_ends(const FlatGrey& grey, int32_t piece, const Image8& rgba) {
  const Box2& box = grey.measured[piece].box;
  const auto reaches_page = [&](int x, int y, int step) {
    while (y >= 0 && y < rgba.height && is_like(rgba, x, y, grey.measured[piece].mean)) y += step;
    return y < 0 || y >= rgba.height || darkest_channel(rgba, x, y) >= palest;
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

/// Of the pieces of that grey what lies in the convex hull of a piece, and what between these and
/// the page is grey and no darker.
Image8 around(const FlatGrey& grey, int32_t piece, const Image8& rgba) {
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

/// What is a shadow with a hard edge: one grey below a figure with outlines, and without one
/// towards the page. Empty where there is none.
Image8 hard_shadow(const Image8& rgba, const Image8& tinted, double middle) {
  const FlatGrey grey = flat_grey(rgba);
  std::vector<int32_t> lying;
  for (int32_t k = 1; k < static_cast<int32_t>(grey.measured.size()); ++k)
    if (lies_below(grey.measured[k].box, share_of(grey.pieces, k), middle) &&
        has_open_ends(grey, k, rgba))
      lying.push_back(k);
  if (lying.empty()) return {};
  PageContacts contacts = find_contacts(grey, tinted, rgba);
  for (const int32_t k : lying) contacts.grey[k] = 0;
  const int64_t bare = std::accumulate(contacts.grey.begin(), contacts.grey.end(), contacts.bare);
  const auto inked = static_cast<double>(contacts.ink);
  if (inked < inked_share * (inked + static_cast<double>(bare))) return {};
  const int32_t largest = *std::max_element(lying.begin(), lying.end(), [&](int32_t a, int32_t b) {
    return grey.pieces.areas[a] < grey.pieces.areas[b];
  });
  return around(grey, largest, rgba);
}

}  // namespace

Image8 without_cast_shadow(const Image8& rgba) {
  for (size_t i = 3; i < rgba.pixels.size(); i += 4)
    if (rgba.pixels[i] < 128) return {};
  const Image8 tinted = tinted_pixels(rgba);
  const Box2 figure = box_of(tinted);
  const double middle = (figure.min.y + figure.max.y - 1) / 2;
  Image8 shadow = lying_pieces(smoothly_reached(rgba), rgba, middle);
  if (std::count(shadow.pixels.begin(), shadow.pixels.end(), 1) == 0) {
    shadow = hard_shadow(rgba, tinted, middle);
    if (shadow.empty()) return {};
  }
  Image8 lit = rgba;
  for (size_t i = 0; i < shadow.pixels.size(); ++i)
    if (shadow.pixels[i] != 0) std::fill_n(&lit.pixels[4 * i], 3, uint8_t{255});
  return lit;
}

}  // namespace relievo::understanding
