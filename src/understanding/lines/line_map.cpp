#include "understanding/lines/line_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/morphology.h"
#include "kernel/image/outlines.h"
#include "understanding/lines/colour_edges.h"

namespace relievo::understanding {
namespace {

constexpr double painted_share = 0.01;  ///< of the box around a drawing that wide colour covers
constexpr int faintest_on_paper = 220;  ///< darkest channel of paint at most, of 255
constexpr int faintest_on_white = 240;  ///< the same on pure white
constexpr int paper_level = 200;        ///< darkest that paper between lines gets, of 255
constexpr int dark_paint = 64;        ///< of 255; on paint up to 2.5 times as bright, ink is judged
constexpr int least_contrast = 96;    ///< by what contrast it can have, but not by less than this
constexpr double least_grain = 0.03;  ///< of the picture, that grain covers at least
constexpr int faintest_line = 14;     ///< contrast below which everything is grain, of 255

/// Half the width of the widest line, px.
double half_line(const Image8& image) {
  return widest_line / 2 * std::hypot(image.width, image.height);
}

int widest_half_line(const Image8& image) {
  return std::max(3, static_cast<int>(std::lround(half_line(image))));
}

/// Whether colour covers more of the drawing than lines could.
bool is_painted(const Image8& rgb, bool on_pure_white) {
  const int factor = std::max(1, std::max(rgb.width, rgb.height) / 100);
  const Image8 cells = shrink(rgb, factor);
  const int faintest = on_pure_white ? faintest_on_white : faintest_on_paper;
  Image8 covered(cells.width, cells.height, 1);
  for (size_t i = 0; i < covered.pixels.size(); ++i) {
    const uint8_t* cell = &cells.pixels[3 * i];
    covered.pixels[i] = std::min({cell[0], cell[1], cell[2]}) < faintest ? 1 : 0;
  }
  const Box2 drawn = box_of(covered);
  if (drawn.empty()) return false;
  const Image8 wide = min_filter(covered, static_cast<int>(std::lround(half_line(cells))) + 1);
  const auto count = std::count(wide.pixels.begin(), wide.pixels.end(), 1);
  const double box = (drawn.max.x - drawn.min.x) * (drawn.max.y - drawn.min.y);
  return static_cast<double>(count) > painted_share * box;
}

/// One value a pixel in which lines are dark: on paint, ink is dark in every channel and paint is
/// not; on paper, a coloured pencil is dark in some channel.
Image8 line_values(const Image8& rgb, bool painted) {
  Image8 values(rgb.width, rgb.height, 1);
  for (size_t i = 0; i < values.pixels.size(); ++i) {
    const uint8_t* p = &rgb.pixels[3 * i];
    values.pixels[i] = painted ? std::max({p[0], p[1], p[2]}) : std::min({p[0], p[1], p[2]});
  }
  return painted ? box_blur(values, 1) : values;
}

/// How much darker a pixel is than the darker of what lies on both sides of it. Among paint, the
/// grain of a pencil differs as much as a faint line, but is not as dark. On paper, shades within
/// ink are not lines.
Image8 darker_than_around(const Image8& values, bool painted) {
  Image8 ink = close_gaps(values, widest_half_line(values));
  for (size_t i = 0; i < values.pixels.size(); ++i) {
    const int around = ink.pixels[i];
    const int contrast = around - values.pixels[i];
    const int on_paper = around < paper_level ? contrast / 3 : contrast;
    // On dark paint ink has little contrast, whatever its width.
    const int most = std::clamp(2 * around - dark_paint, least_contrast, 255);
    const int dark = contrast * (255 - values.pixels[i]) / most;
    ink.pixels[i] = static_cast<uint8_t>(painted ? std::min(dark, 255) : on_paper);
  }
  return ink;
}

/// The threshold that separates a histogram best into two classes (Otsu 1979).
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

/// A histogram. Pixels in turn count in one of four, since additions to one number wait for each
/// other.
std::array<int64_t, 256> count_values(const Image8& image) {
  std::array<std::array<int64_t, 256>, 4> turns = {};
  for (size_t i = 0; i < image.pixels.size(); ++i) ++turns[i % 4][image.pixels[i]];
  std::array<int64_t, 256> counts = {};
  for (const auto& turn : turns)
    for (size_t v = 0; v < counts.size(); ++v) counts[v] += turn[v];
  return counts;
}

/// 1 where the values (one channel) reach `level`.
Image8 reached(const Image8& values, int level) {
  Image8 mask(values.width, values.height, 1);
  for (size_t i = 0; i < mask.pixels.size(); ++i)
    mask.pixels[i] = values.pixels[i] >= level ? 1 : 0;
  return mask;
}

/// What three quarters of the contrasts stay below that are not within a line's width of a line;
/// none where next to nothing is there, since what is left then is faint lines.
int grain_contrast(const Image8& ink, int line) {
  const Image8 near_line = max_filter(reached(ink, line), widest_half_line(ink));
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

/// Contrasts that a line certainly has somewhere, and that it has at least.
struct LineThresholds {
  int sure = 0;
  int possible = 0;
};

/// From the contrasts above the grain. On paper, a line may get as faint as the grain allows; among
/// paint it must stay darker than the strokes that fill areas.
LineThresholds line_thresholds(const Image8& ink, bool painted) {
  std::array<int64_t, 256> above_grain = count_values(ink);
  std::fill(above_grain.begin(), above_grain.begin() + faintest_line / 2, 0);
  const int typical = otsu_threshold(above_grain);
  const int sure = std::max(faintest_line, painted ? typical : 3 * typical / 5);
  const int possible = painted ? 2 * sure / 3 : 7 * grain_contrast(ink, sure) / 2;
  return {sure, std::clamp(possible, faintest_line, sure)};
}

/// Twice the area of the lines over the length of their rim, which is counted along pixel sides.
double typical_width(const Image8& barrier) {
  const auto w = static_cast<size_t>(barrier.width);
  const std::vector<uint8_t>& p = barrier.pixels;
  int64_t area = 0;
  int64_t rim = 0;
  for (size_t i = w; i < p.size(); ++i) {
    area += p[i];
    rim += (p[i] ^ p[i - 1]) + (p[i] ^ p[i - w]);
  }
  // Sides of pixels are 4 / pi times as long as a rim in a random direction.
  const double length = static_cast<double>(rim) * 0.785;
  return rim > 0 ? std::max(1.0, 2 * static_cast<double>(area) / length) : 1;
}

/// As dark as ink, but hardly darker than what lies around it: the inside of a dark shape.
void clear_wide_shapes(const Image8& rgb, int sure, LineMap& map) {
  for (size_t i = 0; i < map.barrier.pixels.size(); ++i)
    if (is_dark(&rgb.pixels[3 * i]) && 2 * map.ink.pixels[i] < sure)
      map.barrier.pixels[i] = LineMap::none;
}

}  // namespace

Image8 connected_above(const Image8& values, int low, int high) {
  const int w = values.width;
  Image8 result(w, values.height, 1);
  std::vector<int> open;
  const auto take = [&](int i) {
    result.pixels[i] = 1;
    open.push_back(i);
  };
  const auto count = static_cast<int>(values.pixels.size());
  for (int i = 0; i < count; ++i)
    if (values.pixels[i] >= high) take(i);
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    const int x = i % w;
    const int y = i / w;
    for (int v = std::max(0, y - 1); v <= std::min(values.height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(w - 1, x + 1); ++u)
        if (result.at(u, v) == 0 && values.at(u, v) >= low) take(v * w + u);
  }
  return result;
}

LineMap find_lines(const Image8& rgb, bool on_pure_white) {
  LineMap map;
  map.painted = is_painted(rgb, on_pure_white);
  const Image8 values = line_values(rgb, map.painted);
  map.ink = darker_than_around(values, map.painted);
  const LineThresholds thresholds = line_thresholds(map.ink, map.painted);
  map.barrier = connected_above(map.ink, thresholds.possible, thresholds.sure);
  if (!map.painted) clear_wide_shapes(rgb, thresholds.sure, map);
  // Where lines may be faint, the barrier holds their blur as well.
  const int middling = (thresholds.sure + thresholds.possible) / 2;
  map.line_width =
      map.painted ? typical_width(map.barrier) : typical_width(reached(map.ink, middling));
  std::array<uint8_t, 256> full = {};
  for (int v = 0; v < 256; ++v)
    full[v] = static_cast<uint8_t>(std::min(255, 128 * v / thresholds.sure));
  for (uint8_t& value : map.ink.pixels) value = full[value];
  add_colour_edges(rgb, map);
  return map;
}

}  // namespace relievo::understanding
