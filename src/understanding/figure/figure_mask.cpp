#include "understanding/figure/figure_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "kernel/image/components.h"
#include "kernel/image/image_size.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "kernel/image/watershed.h"
#include "understanding/lines/line_map.h"
#include "understanding/paper/page.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

// Channels and their differences are of 255.
/// Least share of opaque pixels in the area that they enclose; fewer are lines.
constexpr double solid_share = 0.6;
constexpr int colourful = 44;         ///< difference of channels above which a pixel is no paper
constexpr int clean_white = 248;      ///< least darkest channel of clean paper
constexpr double clean_share = 0.9;   ///< least share of the border that is so white on clean paper
constexpr int palest_on_clean = 228;  ///< darkest channel of paint on clean paper at most
constexpr int half_halo = 2;          ///< px, half width of compression noise beside an outline
constexpr int rim_margin = 2;         ///< px, distance up to which a barrier runs along the rim
constexpr uint8_t rim_ink = 44;       ///< least LineMap::ink of the rim
constexpr double gap_width = 0.008;   ///< width up to which gaps in paint are closed, per diagonal
constexpr double grain_share = 0.02;  ///< area of gaps above which paint is grainy, per figure
constexpr double slit_hole = 0.2;     ///< largest area of a hole behind a slit, per figure
constexpr double border_share = 0.2;  ///< largest share of the border that a figure on paper covers

/// Removes what lies around a page.
Image8 without_surroundings(const Image8& mask) {
  const Components pieces = connected_components(mask, Connectivity::sides);
  const int w = mask.width;
  const int h = mask.height;
  std::vector<std::array<int64_t, 4>> at_edge(pieces.areas.size());
  for (int y = 0; y < h; ++y) {
    ++at_edge[pieces.label.at(0, y)][0];
    ++at_edge[pieces.label.at(w - 1, y)][1];
  }
  for (int x = 0; x < w; ++x) {
    ++at_edge[pieces.label.at(x, 0)][2];
    ++at_edge[pieces.label.at(x, h - 1)][3];
  }
  Image8 result = mask;
  for (size_t i = 0; i < result.pixels.size(); ++i) {
    const int32_t piece = pieces.label.pixels[i];
    if (piece != 0 && is_around_page(at_edge[piece], pieces.areas[piece], w, h))
      result.pixels[i] = 0;
  }
  return result;
}

/// Returns whether the picture's border is white paper without grain or shadows.
bool is_on_clean_paper(const Image8& rgb) {
  const auto is_white = [&](int x, int y) { return darkest_channel(rgb, x, y) >= clean_white; };
  return share_of_edge(rgb.width, rgb.height, is_white) > clean_share;
}

/// Finds the paint: on clean paper all that is not white, else what is too coloured or dark to be a
/// shadow.
Image8 paint(const Image8& rgb, bool on_pure_white) {
  const bool clean = is_on_clean_paper(rgb);
  // Compression noise beside outlines is narrower than this.
  Image8 mask = on_pure_white ? remove_specks(tinted_pixels(rgb), half_halo)
                              : Image8(rgb.width, rgb.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i) {
    const uint8_t* p = &rgb.pixels[3 * i];
    const int brightest = std::max({p[0], p[1], p[2]});
    const int darkest = std::min({p[0], p[1], p[2]});
    const bool coloured = clean ? darkest < palest_on_clean : brightest - darkest > colourful;
    if (coloured || is_dark(p)) mask.pixels[i] = 1;
  }
  return mask;
}

/// Finds the areas that are as dark as ink and too wide for a line.
Image8 dark_shapes(const Image8& rgb, const Image8& barrier) {
  const Image8 dark = mask_where(rgb.width, rgb.height, [&](size_t i) {
    return is_dark(&rgb.pixels[3 * i]) && barrier.pixels[i] != LineMap::line;
  });
  return without_surroundings(remove_specks(dark, 1));
}

/// Closes the gaps in a mask, except those between it and the picture's border.
Image8 without_gaps(const Image8& mask, int half_gap) {
  Image8 closed = close_gaps(mask, half_gap);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const int to_edge = std::min({x, y, mask.width - 1 - x, mask.height - 1 - y});
      if (to_edge < half_gap) closed.at(x, y) = mask.at(x, y);
    }
  return closed;
}

/// Opens again the closed gaps in front of small holes, such as the slit between the feet below two
/// legs. Grainy paint, such as crayon, has gaps all over, which stay closed.
void open_slits(const Image8& paint, Image8& closed) {
  Image8 added = closed;
  for (size_t i = 0; i < added.pixels.size(); ++i)
    if (paint.pixels[i] != 0) added.pixels[i] = 0;
  const auto figure = static_cast<double>(pixel_count(closed));
  if (static_cast<double>(pixel_count(added)) > grain_share * figure) return;
  const Components gaps = connected_components(added, Connectivity::sides);
  const Components open = connected_components(complement(closed), Connectivity::sides);
  const std::vector<uint8_t> is_page = pieces_at_edge(open);
  std::vector<int64_t> hole(gaps.areas.size(), 0);  // area of the largest hole at each gap, px
  for (int y = 1; y + 1 < closed.height; ++y)
    for (int x = 1; x + 1 < closed.width; ++x) {
      const int32_t gap = gaps.label.at(x, y);
      if (gap == 0) continue;
      for (const auto& [u, v] : side_neighbours(x, y)) {
        const int32_t piece = open.label.at(u, v);
        if (piece != 0 && is_page[piece] == 0) hole[gap] = std::max(hole[gap], open.areas[piece]);
      }
    }
  for (size_t i = 0; i < closed.pixels.size(); ++i) {
    const int64_t area = hole[gaps.label.pixels[i]];
    if (area > 0 && static_cast<double>(area) < slit_hole * figure) closed.pixels[i] = 0;
  }
}

}  // namespace

FigureMask find_figure(const Image8& rgba, const Image8& rgb, const LineMap& map,
                       bool on_pure_white) {
  const Image8 opaque =
      mask_where(rgba.width, rgba.height, [&](size_t i) { return rgba.pixels[4 * i + 3] >= 128; });
  const int64_t pixels = pixel_count(opaque);
  if (pixels < static_cast<int64_t>(opaque.pixels.size())) {
    const auto surrounded = static_cast<double>(pixel_count(without_holes(opaque)));
    if (static_cast<double>(pixels) < solid_share * surrounded || pixels == 0) return {};
    return {opaque, true, true};
  }
  if (!map.painted) return {dark_shapes(rgb, map.barrier), false, true};
  const int half_gap =
      std::max(1, static_cast<int>(std::lround(gap_width / 2 * std::hypot(rgb.width, rgb.height))));
  const Image8 paint_on_page = without_surroundings(paint(rgb, on_pure_white));
  Image8 closed = without_gaps(paint_on_page, half_gap);
  open_slits(paint_on_page, closed);
  const Image8 figure = without_small_pieces(without_holes(closed));
  const auto is_inside = [&](int x, int y) { return figure.at(x, y) != 0; };
  const double most = on_pure_white ? 1 - bust_share : border_share;
  if (share_of_edge(rgb.width, rgb.height, is_inside) > most) return {};
  // The blurred pixels of its rim are half paper.
  return {min_filter(figure, 1), false, on_pure_white};
}

void mark_rim(const FigureMask& figure, LineMap& map) {
  if (figure.inside.empty() || !figure.sharp) return;
  const Image8 near_barrier = max_filter(map.barrier, rim_margin);
  const Image8 core = min_filter(figure.inside, 1);
  for (size_t i = 0; i < core.pixels.size(); ++i) {
    if (figure.inside.pixels[i] == core.pixels[i] || near_barrier.pixels[i] != 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], rim_ink);
  }
}

}  // namespace relievo::understanding
