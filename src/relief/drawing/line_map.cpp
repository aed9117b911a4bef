#include "relief/drawing/line_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/morphology.h"
#include "relief/drawing/colour_edges.h"
#include "relief/drawing/hysteresis.h"

namespace relievo {
namespace {

constexpr double painted_share = 0.01;  ///< of the picture that is covered by wide colour
constexpr int paper_level = 220;        ///< darkest that paper gets, of 255
constexpr int faintest_line = 14;       ///< contrast below which everything is grain, of 255

int widest_half_line(const Image8& image) {
  return std::max(
      3, static_cast<int>(std::lround(widest_line / 2 * std::hypot(image.width, image.height))));
}

/// Whether colour covers more of the picture than lines could.
bool is_painted(const Image8& rgb) {
  const int factor = std::max(1, std::max(rgb.width, rgb.height) / 100);
  const Image8 cells = shrink(rgb, factor);
  Image8 covered(cells.width, cells.height, 1);
  for (size_t i = 0; i < covered.pixels.size(); ++i) {
    const uint8_t* cell = &cells.pixels[3 * i];
    covered.pixels[i] = std::min({cell[0], cell[1], cell[2]}) < paper_level ? 1 : 0;
  }
  const Image8 wide = min_filter(covered, widest_half_line(cells) + 1);
  const auto count = std::count(wide.pixels.begin(), wide.pixels.end(), 1);
  return static_cast<double>(count) > painted_share * static_cast<double>(wide.pixels.size());
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
/// grain of a pencil differs as much as a faint line, but is not as dark.
Image8 darker_than_around(const Image8& values, bool painted) {
  Image8 ink = close_gaps(values, widest_half_line(values));
  for (size_t i = 0; i < values.pixels.size(); ++i) {
    const int contrast = ink.pixels[i] - values.pixels[i];
    ink.pixels[i] =
        static_cast<uint8_t>(painted ? contrast * (255 - values.pixels[i]) / 255 : contrast);
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

/// Contrast that a line certainly has, from the contrasts above the grain.
int line_threshold(const Image8& ink) {
  std::array<int64_t, 256> counts = {};
  for (const uint8_t value : ink.pixels) ++counts[value];
  std::fill(counts.begin(), counts.begin() + faintest_line / 2, 0);
  return std::max(faintest_line, otsu_threshold(counts));
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

}  // namespace

LineMap find_lines(const Image8& rgb) {
  LineMap map;
  map.painted = is_painted(rgb);
  const Image8 values = line_values(rgb, map.painted);
  map.ink = darker_than_around(values, map.painted);
  const int sure = line_threshold(map.ink);
  const int possible = map.painted ? 2 * sure / 3 : sure / 2;
  map.barrier = connected_above(map.ink, std::max(faintest_line, possible), sure);
  map.line_width = typical_width(map.barrier);
  for (uint8_t& value : map.ink.pixels)
    value = static_cast<uint8_t>(std::min(255, 128 * value / sure));
  add_colour_edges(rgb, map);
  return map;
}

}  // namespace relievo
