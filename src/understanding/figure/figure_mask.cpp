#include "understanding/figure/figure_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "kernel/image/components.h"
#include "kernel/image/image_size.h"
#include "kernel/image/mask_pieces.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "kernel/image/watershed.h"
#include "understanding/paper/page.h"
#include "understanding/paper/pure_white.h"

namespace relievo::understanding {
namespace {

constexpr double solid_share = 0.6;   ///< of what opaque pixels surround, from which they are areas
constexpr int colourful = 44;         ///< difference of channels, of 255, of what is no paper
constexpr int clean_white = 248;      ///< darkest channel of white paper at least
constexpr double clean_share = 0.9;   ///< of the picture's edge that is so white on clean paper
constexpr int faintest = 228;         ///< darkest channel of paint on clean paper at most
constexpr int half_halo = 2;          ///< px, of what a codec leaves beside an outline
constexpr int rim_margin = 2;         ///< px, within which an edge is that of the figure
constexpr uint8_t rim_ink = 44;       ///< of LineMap::ink, that the rim has at least
constexpr double gap_width = 0.008;   ///< of the diagonal, up to which gaps in paint are closed
constexpr double grain_share = 0.02;  ///< of the figure; gaps in grainy paint are more
constexpr double slit_hole = 0.2;     ///< of the figure; a hole behind a slit is less
constexpr double at_edge_share = 0.2;  ///< of the picture's edge; more is no figure on paper

/// Without what lies around the page.
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
    if (piece != 0 && is_surroundings(at_edge[piece], pieces.areas[piece], w, h))
      result.pixels[i] = 0;
  }
  return result;
}

Image8 opaque_pixels(const Image8& rgba) {
  Image8 mask(rgba.width, rgba.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = rgba.pixels[4 * i + 3] >= 128 ? 1 : 0;
  return mask;
}

/// Whether the picture's edge is white paper without grain or shadows.
bool is_on_clean_paper(const Image8& rgb) {
  const auto is_white = [&](int x, int y) { return darkest_channel(rgb, x, y) >= clean_white; };
  return share_of_edge(rgb.width, rgb.height, is_white) > clean_share;
}

/// What is no paper: on clean paper whatever is not white, else what no shadow is.
Image8 paint(const Image8& rgb, bool on_pure_white) {
  const bool clean = is_on_clean_paper(rgb);
  // Broader than what a codec leaves beside an outline.
  Image8 mask = on_pure_white ? remove_specks(tinted_pixels(rgb), half_halo)
                              : Image8(rgb.width, rgb.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i) {
    const uint8_t* p = &rgb.pixels[3 * i];
    const int brightest = std::max({p[0], p[1], p[2]});
    const int darkest = std::min({p[0], p[1], p[2]});
    const bool coloured = clean ? darkest < faintest : brightest - darkest > colourful;
    if (coloured || is_dark(p)) mask.pixels[i] = 1;
  }
  return mask;
}

/// What is as dark as ink and too wide for a line.
Image8 dark_shapes(const Image8& rgb, const Image8& barrier) {
  Image8 mask(rgb.width, rgb.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = is_dark(&rgb.pixels[3 * i]) && barrier.pixels[i] != LineMap::line ? 1 : 0;
  return without_surroundings(remove_specks(mask, 1));
}

/// With the gaps in it closed, but for those between it and the picture's edge.
Image8 without_gaps(const Image8& mask, int half_gap) {
  Image8 closed = close_gaps(mask, half_gap);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const int to_edge = std::min({x, y, mask.width - 1 - x, mask.height - 1 - y});
      if (to_edge < half_gap) closed.at(x, y) = mask.at(x, y);
    }
  return closed;
}

/// Opens again what was closed before a hole, as the slit between the feet of legs that stand
/// together, unless the hole is large. Grainy paint, as that of crayons, has gaps all over, which
/// say nothing.
void open_slits(const Image8& paint, Image8& closed) {
  Image8 added = closed;
  for (size_t i = 0; i < added.pixels.size(); ++i)
    if (paint.pixels[i] != 0) added.pixels[i] = 0;
  const auto figure = static_cast<double>(pixel_count(closed));
  if (static_cast<double>(pixel_count(added)) > grain_share * figure) return;
  const Components gaps = connected_components(added, Connectivity::sides);
  const Components open = connected_components(complement(closed), Connectivity::sides);
  const std::vector<uint8_t> is_page = pieces_at_edge(open);
  std::vector<int64_t> hole(gaps.areas.size(), 0);  // the largest beside each gap, px
  for (int y = 1; y + 1 < closed.height; ++y)
    for (int x = 1; x + 1 < closed.width; ++x) {
      const int32_t gap = gaps.label.at(x, y);
      if (gap == 0) continue;
      for (const auto& [u, v] : sides_of(x, y)) {
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
  const Image8 opaque = opaque_pixels(rgba);
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
  const double most = on_pure_white ? 1 - bust_share : at_edge_share;
  if (share_of_edge(rgb.width, rgb.height, is_inside) > most) return {};
  // The blur of its rim is half paper.
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
