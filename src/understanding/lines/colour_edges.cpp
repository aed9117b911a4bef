#include "understanding/lines/colour_edges.h"

#include <algorithm>
#include <vector>

#include "kernel/image/blur.h"
#include "kernel/image/components.h"
#include "kernel/image/morphology.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

constexpr int sure_gradient = 44;      ///< gradient that makes an edge, of 255 a channel over 2 px
constexpr int possible_gradient = 22;  ///< gradient that continues an edge, likewise
constexpr int flank_margin = 4;        ///< px around lines, whose own flanks are no edges

/// Computes by pixel the largest difference of a channel between two rows of `largest.size()`
/// pixels. `channels` is working memory of three values a pixel and two more.
void row_difference(const uint8_t* a, const uint8_t* b, std::vector<uint8_t>& channels,
                    std::vector<uint8_t>& largest) {
  const size_t n = 3 * largest.size();
  for (size_t i = 0; i < n; ++i) {
    const uint8_t high = a[i] > b[i] ? a[i] : b[i];
    const uint8_t low = a[i] > b[i] ? b[i] : a[i];
    channels[i] = static_cast<uint8_t>(high - low);
  }
  for (size_t x = 0; x < largest.size(); ++x)
    largest[x] = std::max({channels[3 * x], channels[3 * x + 1], channels[3 * x + 2]});
}

/// Computes the size of the gradient where `excluded` is 0, and 0 elsewhere and at the picture's
/// edge; `along_x` becomes 1 where it is larger along x than along y.
Image8 measure_gradient(const Image8& rgb, const Image8& excluded, Image8& along_x) {
  Image8 gradient(rgb.width, rgb.height, 1);
  along_x = Image8(rgb.width, rgb.height, 1);
  const int inside = rgb.width - 2;
  if (inside <= 0) return gradient;
  std::vector<uint8_t> channels(3 * static_cast<size_t>(inside) + 2);
  std::vector<uint8_t> differences_x(inside);
  std::vector<uint8_t> differences_y(inside);
  for (int y = 1; y + 1 < rgb.height; ++y) {
    row_difference(&rgb.at(2, y), &rgb.at(0, y), channels, differences_x);
    row_difference(&rgb.at(1, y + 1), &rgb.at(1, y - 1), channels, differences_y);
    const uint8_t* skip = &excluded.at(1, y);
    uint8_t* size = &gradient.at(1, y);
    uint8_t* is_x = &along_x.at(1, y);
    for (int x = 0; x < inside; ++x) {
      const int dx = differences_x[x];
      const int dy = differences_y[x];
      const int sum = dx > dy ? dx + dy / 2 : dy + dx / 2;
      size[x] = static_cast<uint8_t>(skip[x] != 0 ? 0 : std::min(255, sum));
      is_x[x] = dx >= dy ? 1 : 0;
    }
  }
  return gradient;
}

/// Keeps the gradient where it is largest across its edge; 0 elsewhere.
Image8 ridges(const Image8& size, const Image8& along_x) {
  Image8 result(size.width, size.height, 1);
  for (int y = 1; y + 1 < size.height; ++y)
    for (int x = 1; x + 1 < size.width; ++x) {
      const uint8_t value = size.at(x, y);
      if (value < possible_gradient) continue;
      const bool across_x = along_x.at(x, y) != 0;
      const uint8_t before = across_x ? size.at(x - 1, y) : size.at(x, y - 1);
      const uint8_t after = across_x ? size.at(x + 1, y) : size.at(x, y + 1);
      if (value > before && value >= after) result.at(x, y) = value;
    }
  return result;
}

}  // namespace

void add_colour_edges(const Image8& rgb, LineMap& map) {
  const Image8 smooth = box_blur(rgb, map.painted ? 2 : 1);
  const Image8 near_line = max_filter(map.barrier, flank_margin);
  Image8 along_x;
  const Image8 gradient = measure_gradient(smooth, near_line, along_x);
  const Image8 edges =
      hysteresis_threshold(ridges(gradient, along_x), possible_gradient, sure_gradient);
  for (size_t i = 0; i < edges.pixels.size(); ++i) {
    if (edges.pixels[i] == 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], gradient.pixels[i]);
  }
}

void add_cut_edges(const Image8& rgba, LineMap& map) {
  const auto is_opaque = [&](int x, int y) { return rgba.at(x, y, 3) >= 128; };
  const Image8 near_barrier = max_filter(map.barrier, flank_margin);
  for (int y = 1; y + 1 < rgba.height; ++y)
    for (int x = 1; x + 1 < rgba.width; ++x) {
      if (!is_opaque(x, y) || near_barrier.at(x, y) != 0) continue;
      if (is_opaque(x - 1, y) && is_opaque(x + 1, y) && is_opaque(x, y - 1) && is_opaque(x, y + 1))
        continue;
      map.barrier.at(x, y) = LineMap::edge;
      map.ink.at(x, y) = 255;
    }
}

void add_contours(const Image8& contour, int least, int margin, LineMap& map) {
  const Image8 near_barrier = max_filter(map.barrier, margin);
  for (size_t i = 0; i < contour.pixels.size(); ++i) {
    if (contour.pixels[i] < least || near_barrier.pixels[i] != 0) continue;
    map.barrier.pixels[i] = LineMap::edge;
    map.ink.pixels[i] = std::max(map.ink.pixels[i], contour.pixels[i]);
  }
}

}  // namespace relievo::understanding
