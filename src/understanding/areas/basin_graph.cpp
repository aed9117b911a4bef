#include "understanding/areas/basin_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "understanding/lines/line_map.h"

namespace relievo::understanding {
namespace {

/// Distance from a border at which the colours beside it are taken, per diagonal of the picture:
/// beyond a soft edge, but not across much shading.
constexpr double beside_share = 0.015;

/// Adds the pixels [begin, end), which lie in one row and basin.
void add_run(const Image8& rgba, const Image8& rgb, const Basins& basins, size_t begin, size_t end,
             Basin& basin) {
  const Image8& barrier = basins.barrier;
  uint32_t coloured = 0;
  uint32_t figure = 0;
  uint32_t transparent = 0;
  uint64_t squares = 0;
  std::array<uint32_t, 3> sum = {};
  for (size_t i = begin; i < end; ++i) {
    const uint32_t counts = barrier.pixels[i] == 0 ? 1 : 0;
    coloured += counts;
    figure += basins.figure.pixels[i];
    transparent += rgba.pixels[4 * i + 3] < 128 ? 1 : 0;
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t value = rgb.pixels[3 * i + c];
      sum[c] += counts * value;
      squares += uint64_t{counts} * value * value;
    }
  }
  basin.figure += figure;
  basin.transparent += transparent;
  basin.colour_squares += static_cast<int64_t>(squares);
  basin.area += static_cast<int64_t>(end - begin);
  basin.coloured += coloured;
  for (size_t c = 0; c < 3; ++c) basin.colour_sum[c] += sum[c];
}

void measure_areas(const Image8& rgba, const Image8& rgb, Basins& basins) {
  const int w = basins.index.width;
  for (int y = 0; y < basins.index.height; ++y) {
    const int32_t* row = &basins.index.at(0, y);
    const size_t first = static_cast<size_t>(y) * w;
    for (int begin = 0, end = 0; begin < w; begin = end) {
      while (end < w && row[end] == row[begin]) ++end;
      Basin& basin = basins.basins[row[begin]];
      add_run(rgba, rgb, basins, first + begin, first + end, basin);
      basin.box.add(Point2{begin * 1.0, y * 1.0});
      basin.box.add(Point2{end * 1.0, y + 1.0});
    }
  }
}

/// Counts the pixels off the lines at the edges of the picture.
void measure_edges(Basins& basins) {
  const int w = basins.index.width;
  const int h = basins.index.height;
  const auto count_at_edge = [&](int x, int y, size_t edge) {
    if (basins.barrier.at(x, y) == 0) ++basins.basins[basins.index.at(x, y)].at_edge[edge];
  };
  for (int y = 0; y < h; ++y) {
    count_at_edge(0, y, 0);
    count_at_edge(w - 1, y, 1);
  }
  for (int x = 0; x < w; ++x) {
    count_at_edge(x, 0, 2);
    count_at_edge(x, h - 1, 3);
  }
}

/// Collects the pairs of neighbouring pixels in different basins.
class PairCollector {
 public:
  /// Measures no steps of colour where `rgb` is null.
  PairCollector(const Basins& basins, const Image8* rgb)
      : basins_(basins),
        rgb_(rgb),
        unit_(white_cost(basins.index.width, basins.index.height)),
        beside_(std::max(2, static_cast<int>(beside_share * std::hypot(basins.index.width,
                                                                       basins.index.height)))) {}

  /// Adds the pairs of the pixels x0 ... x1 - 1 of a row with each other and with those below.
  void add_row(int y, int x0, int x1, bool with_below) {
    const size_t w = basins_.index.width;
    const int32_t* row = &basins_.index.at(0, y);
    for (int x = x0; x < x1; ++x) {
      const size_t i = y * w + x;
      if (x + 1 < x1 && row[x + 1] != row[x]) add_pair(i, i + 1);
      if (with_below && row[x + w] != row[x]) add_pair(i, i + w);
    }
  }

  /// Sums the pairs of every border, sorted by a, b.
  std::vector<BasinBorder> borders() {
    std::sort(pairs_.begin(), pairs_.end(), [](const BasinBorder& x, const BasinBorder& y) {
      return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
    std::vector<BasinBorder> merged;
    for (const BasinBorder& pair : pairs_) {
      if (merged.empty() || merged.back().a != pair.a || merged.back().b != pair.b) {
        merged.push_back(pair);
        continue;
      }
      merged.back().add(pair);
      merged.back().weight += pair.weight;
    }
    return merged;
  }

 private:
  /// Adds a pair with LazyBrush's weight 1 + K I^2, where I is the whiteness of its darker pixel.
  void add_pair(size_t i, size_t j) {
    const int32_t a = basins_.index.pixels[i];
    const int32_t b = basins_.index.pixels[j];
    const uint8_t p = basins_.barrier.pixels[i];
    const uint8_t q = basins_.barrier.pixels[j];
    const bool line = LineMap::is_wall(p) || LineMap::is_wall(q);
    const bool edge = !line && (p == LineMap::edge || q == LineMap::edge);
    const int64_t ink = std::max(basins_.ink.pixels[i], basins_.ink.pixels[j]);
    const int64_t white = 255 - ink;
    const int64_t near = std::max(basins_.near_contour.pixels[i], basins_.near_contour.pixels[j]);
    pairs_.push_back({{1,
                       line ? 1 : 0,
                       edge ? 1 : 0,
                       ink,
                       std::max(basins_.contour.pixels[i], basins_.contour.pixels[j]),
                       near,
                       near > 127 ? 1 : 0,
                       {}},
                      std::min(a, b),
                      std::max(a, b),
                      1 + unit_ * white * white / (255 * 255)});
    if (rgb_ == nullptr) return;
    if (b < a) std::swap(i, j);
    const size_t in_a = pixel_beside(i, j);
    const size_t in_b = pixel_beside(j, i);
    for (size_t c = 0; c < 3; ++c)
      pairs_.back().step[c] =
          int64_t{rgb_->pixels[3 * in_b + c]} - int64_t{rgb_->pixels[3 * in_a + c]};
  }

  /// Returns the pixel at distance `beside_` from a pair on the side of `own`, beyond the barrier
  /// that it lies on, or the last one before its basin ends or another barrier begins.
  size_t pixel_beside(size_t own, size_t other) const {
    const int x = static_cast<int>(own % basins_.index.width);
    const int y = static_cast<int>(own / basins_.index.width);
    const int way_x = x - static_cast<int>(other % basins_.index.width);
    const int way_y = y - static_cast<int>(other / basins_.index.width);
    const auto step = static_cast<ptrdiff_t>(own) - static_cast<ptrdiff_t>(other);
    size_t found = own;
    size_t next = own;
    for (int k = 1; k <= beside_; ++k) {
      const int u = x + k * way_x;
      const int v = y + k * way_y;
      if (u < 0 || v < 0 || u >= basins_.index.width || v >= basins_.index.height) break;
      next = static_cast<size_t>(static_cast<ptrdiff_t>(next) + step);
      if (basins_.index.pixels[next] != basins_.index.pixels[own]) break;
      const bool barred = basins_.barrier.pixels[next] != LineMap::none;
      if (barred && basins_.barrier.pixels[found] == LineMap::none) break;
      found = next;
    }
    return found;
  }

  const Basins& basins_;
  const Image8* rgb_;
  int64_t unit_;  ///< K
  int beside_;    ///< px
  std::vector<BasinBorder> pairs_;
};

}  // namespace

std::vector<BasinBorder> borders_within(const Basins& basins, int x0, int y0, int x1, int y1,
                                        const Image8* rgb) {
  PairCollector pairs(basins, rgb);
  for (int y = y0; y < y1; ++y) pairs.add_row(y, x0, x1, y + 1 < y1);
  return pairs.borders();
}

void measure_borders(const Image8& rgb, Basins& basins) {
  basins.borders = borders_within(basins, 0, 0, basins.index.width, basins.index.height, &rgb);
}

void measure_basins(const Image8& rgba, const Image8& rgb, Basins& basins) {
  for (Basin& basin : basins.basins) {
    const double inradius = basin.inradius;
    basin = {};
    basin.inradius = inradius;
  }
  measure_areas(rgba, rgb, basins);
  measure_edges(basins);
  measure_borders(rgb, basins);
}

}  // namespace relievo::understanding
