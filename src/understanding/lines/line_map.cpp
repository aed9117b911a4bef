#include "understanding/lines/line_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/components.h"
#include "kernel/image/mask.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/colour_edges.h"

namespace relievo::understanding {
namespace {

/// Area of paint wider than lines, per area of the box around the drawing, above which the drawing
/// is painted.
constexpr double painted_share = 0.01;
constexpr int palest_on_paper = 220;  ///< darkest channel of paint on paper at most, of 255
constexpr int palest_on_white = 240;  ///< darkest channel of paint on pure white at most, of 255
constexpr int paper_level = 200;  ///< darkest channel of the paper between lines at least, of 255
/// Ink on paint of brightness v has a contrast of up to 2 v - dark_paint, of 255, but at most 255;
/// contrasts are normalised by that value, which is at least least_contrast.
constexpr int dark_paint = 64;
constexpr int least_contrast = 96;
constexpr double least_grain = 0.03;  ///< share of the picture that grain covers at least
constexpr int faintest_line = 14;     ///< contrast below which everything is grain, of 255

/// Computes half the width of the widest line, px.
double half_line(const Image8& image) {
  return widest_line / 2 * std::hypot(image.width, image.height);
}

int widest_half_line(const Image8& image) {
  return std::max(3, static_cast<int>(std::lround(half_line(image))));
}

/// Returns whether colour covers more of the drawing than lines could.
bool is_painted(const Image8& rgb, bool on_pure_white) {
  const int factor = std::max(1, std::max(rgb.width, rgb.height) / 100);
  const Image8 cells = shrink(rgb, factor);
  const int palest = on_pure_white ? palest_on_white : palest_on_paper;
  const Image8 covered = mask_where(cells.width, cells.height, [&](size_t i) {
    const uint8_t* cell = &cells.pixels[3 * i];
    return std::min({cell[0], cell[1], cell[2]}) < palest;
  });
  const Box2 drawn = box_of(covered);
  if (drawn.empty()) return false;
  const Image8 wide = min_filter(covered, static_cast<int>(std::lround(half_line(cells))) + 1);
  const double box = (drawn.max.x - drawn.min.x) * (drawn.max.y - drawn.min.y);
  return static_cast<double>(pixel_count(wide)) > painted_share * box;
}

/// Returns one value a pixel in which lines are dark. On paint this is the brightest channel, since
/// only ink is dark in all; on paper the darkest, since a coloured pencil is dark in one alone.
Image8 line_values(const Image8& rgb, bool painted) {
  Image8 values(rgb.width, rgb.height, 1);
  for (size_t i = 0; i < values.pixels.size(); ++i) {
    const uint8_t* p = &rgb.pixels[3 * i];
    values.pixels[i] = painted ? std::max({p[0], p[1], p[2]}) : std::min({p[0], p[1], p[2]});
  }
  return painted ? box_blur(values, 1) : values;
}

/// Computes the black top-hat transform: how much darker a pixel is than the darker of its two
/// sides. Among paint it is weighed by the pixel's darkness, since the grain of a pencil has the
/// contrast of a faint line and is brighter. On paper it is reduced inside dark shapes, whose
/// shades are no lines.
Image8 black_top_hat(const Image8& values, bool painted) {
  Image8 ink = close_gaps(values, widest_half_line(values));
  for (size_t i = 0; i < values.pixels.size(); ++i) {
    const int around = ink.pixels[i];
    const int contrast = around - values.pixels[i];
    const int on_paper = around < paper_level ? contrast / 3 : contrast;
    // Ink has little contrast on dark paint.
    const int most = std::clamp(2 * around - dark_paint, least_contrast, 255);
    const int dark = contrast * (255 - values.pixels[i]) / most;
    ink.pixels[i] = static_cast<uint8_t>(painted ? std::min(dark, 255) : on_paper);
  }
  return ink;
}

/// Finds the threshold that best separates a histogram into two classes (Otsu 1979).
int otsu_threshold(const std::array<int64_t, 256>& counts) {
  double total = 0;
  double sum = 0;
  for (int v = 0; v < 256; ++v) {
    total += static_cast<double>(counts[v]);
    sum += v * static_cast<double>(counts[v]);
  }
  double below = 0;
  double below_sum = 0;
  double best = -1;
  int threshold = 0;
  for (int v = 0; v < 255; ++v) {
    below += static_cast<double>(counts[v]);
    below_sum += v * static_cast<double>(counts[v]);
    if (below == 0 || below == total) continue;
    const double difference = below_sum / below - (sum - below_sum) / (total - below);
    const double between = below * (total - below) * difference * difference;
    if (between <= best) continue;
    best = between;
    threshold = v;
  }
  return threshold;
}

/// Computes the histogram of an image. Four histograms are filled in turn and added, since
/// additions to one counter wait for each other.
std::array<int64_t, 256> count_values(const Image8& image) {
  std::array<std::array<int64_t, 256>, 4> turns = {};
  for (size_t i = 0; i < image.pixels.size(); ++i) ++turns[i % 4][image.pixels[i]];
  std::array<int64_t, 256> counts = {};
  for (const auto& turn : turns)
    for (size_t v = 0; v < counts.size(); ++v) counts[v] += turn[v];
  return counts;
}

/// Returns 1 where the values (one channel) reach `level`, 0 elsewhere.
Image8 at_least(const Image8& values, int level) {
  return mask_where(values.width, values.height,
                    [&](size_t i) { return values.pixels[i] >= level; });
}

/// Estimates the contrast of the paper's grain: the upper quartile of the contrasts farther from
/// lines than the widest line is wide. It is 0 where fewer than `least_grain` of the pixels there
/// have any, since these are faint lines. `line` is the contrast of a certain line.
int grain_contrast(const Image8& ink, int line) {
  const Image8 near_line = max_filter(at_least(ink, line), widest_half_line(ink));
  std::array<int64_t, 256> counts = {};
  for (size_t i = 0; i < ink.pixels.size(); ++i)
    if (near_line.pixels[i] == 0) ++counts[ink.pixels[i]];
  const auto all = std::accumulate(counts.begin(), counts.end(), int64_t{0});
  const auto least = static_cast<int64_t>(least_grain * static_cast<double>(all));
  int64_t left = std::max((all - counts[0]) / 4, least);
  int contrast = 255;
  while (contrast > 0 && (left -= counts[contrast]) >= 0) --contrast;
  return contrast;
}

/// Computes the contrast that a line has somewhere along it, from the contrasts above the grain.
int sure_contrast(const Image8& ink, bool painted) {
  std::array<int64_t, 256> above_grain = count_values(ink);
  std::fill(above_grain.begin(), above_grain.begin() + faintest_line / 2, 0);
  const int typical = otsu_threshold(above_grain);
  return std::max(faintest_line, painted ? typical : 3 * typical / 5);
}

/// Computes the contrast that a line has all along it. On paper a line may fade to the contrast of
/// the grain; among paint it stays darker than the strokes that fill areas.
int possible_contrast(const Image8& ink, int sure, bool painted) {
  const int possible = painted ? 2 * sure / 3 : 7 * grain_contrast(ink, sure) / 2;
  return std::clamp(possible, faintest_line, sure);
}

/// Computes the typical width of lines, px: twice their area over the length of their rim.
double typical_width(const Image8& barrier) {
  const auto w = static_cast<size_t>(barrier.width);
  const std::vector<uint8_t>& p = barrier.pixels;
  int64_t area = 0;
  int64_t rim = 0;
  for (size_t i = w; i < p.size(); ++i) {
    area += p[i];
    rim += (p[i] ^ p[i - 1]) + (p[i] ^ p[i - w]);
  }
  // Pixel sides along a rim in a random direction are 4 / pi times as long as the rim.
  const double length = static_cast<double>(rim) * 0.785;
  return rim > 0 ? std::max(1.0, 2 * static_cast<double>(area) / length) : 1;
}

/// Removes the insides of dark shapes from the lines: pixels as dark as ink that are hardly darker
/// than their surroundings.
void clear_wide_shapes(const Image8& rgb, int sure, LineMap& map) {
  for (size_t i = 0; i < map.barrier.pixels.size(); ++i)
    if (is_dark(&rgb.pixels[3 * i]) && 2 * map.ink.pixels[i] < sure)
      map.barrier.pixels[i] = LineMap::none;
}

}  // namespace

LineMap find_lines(const Image8& rgb, bool on_pure_white) {
  LineMap map;
  map.painted = is_painted(rgb, on_pure_white);
  const Image8 values = line_values(rgb, map.painted);
  map.ink = black_top_hat(values, map.painted);
  const int sure = sure_contrast(map.ink, map.painted);
  const int possible = possible_contrast(map.ink, sure, map.painted);
  map.barrier = hysteresis_threshold(map.ink, possible, sure);
  if (!map.painted) clear_wide_shapes(rgb, sure, map);
  // Where lines may be faint, the barrier includes their blurred rims, so it would be too wide.
  map.line_width =
      typical_width(map.painted ? map.barrier : at_least(map.ink, (sure + possible) / 2));
  std::array<uint8_t, 256> full = {};
  for (int v = 0; v < 256; ++v) full[v] = static_cast<uint8_t>(std::min(255, 128 * v / sure));
  for (uint8_t& value : map.ink.pixels) value = full[value];
  add_colour_edges(rgb, map);
  return map;
}

}  // namespace relievo::understanding
