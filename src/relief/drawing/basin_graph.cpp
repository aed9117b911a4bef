#include "relief/drawing/basin_graph.h"

#include <algorithm>

#include "relief/drawing/line_map.h"

namespace relievo {
namespace {

void measure_areas(const Image8& rgba, const Image8& rgb, Basins& basins) {
  const int w = basins.index.width;
  const int h = basins.index.height;
  for (size_t i = 0; i < basins.index.pixels.size(); ++i) {
    Basin& basin = basins.basins[basins.index.pixels[i]];
    ++basin.area;
    if (basins.barrier.pixels[i] != 0) continue;
    ++basin.coloured;
    basin.transparent += rgba.pixels[4 * i + 3] < 128 ? 1 : 0;
    for (size_t c = 0; c < 3; ++c) basin.colour_sum[c] += rgb.pixels[3 * i + c];
  }
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

void measure_boxes(Basins& basins) {
  const int w = basins.index.width;
  for (int y = 0; y < basins.index.height; ++y) {
    const int32_t* row = &basins.index.at(0, y);
    for (int begin = 0, end = 0; begin < w; begin = end) {
      while (end < w && row[end] == row[begin]) ++end;
      basins.basins[row[begin]].box.add(Point2{static_cast<double>(begin), static_cast<double>(y)});
      basins.basins[row[begin]].box.add(Point2{end * 1.0, y + 1.0});
    }
  }
}

/// Collects the pairs of neighbouring pixels that lie in different basins.
class PairCollector {
 public:
  explicit PairCollector(const Basins& basins)
      : basins_(basins), unit_(white_cost(basins.index.width, basins.index.height)) {}

  void add(size_t i, size_t j) {
    if (basins_.index.pixels[i] != basins_.index.pixels[j]) add_pair(i, j);
  }

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
      merged.back().pairs += pair.pairs;
      merged.back().line_pairs += pair.line_pairs;
      merged.back().edge_pairs += pair.edge_pairs;
      merged.back().weight += pair.weight;
    }
    return merged;
  }

 private:
  void add_pair(size_t i, size_t j) {
    const int32_t a = basins_.index.pixels[i];
    const int32_t b = basins_.index.pixels[j];
    const uint8_t p = basins_.barrier.pixels[i];
    const uint8_t q = basins_.barrier.pixels[j];
    const bool line = p == LineMap::line || q == LineMap::line;
    const bool edge = !line && (p == LineMap::edge || q == LineMap::edge);
    const int64_t white = 255 - std::max(basins_.ink.pixels[i], basins_.ink.pixels[j]);
    pairs_.push_back({std::min(a, b), std::max(a, b), 1, line ? 1 : 0, edge ? 1 : 0,
                      1 + unit_ * white * white / (255 * 255)});
  }

  const Basins& basins_;
  int64_t unit_;
  std::vector<BasinBorder> pairs_;
};

}  // namespace

std::vector<BasinBorder> borders_within(const Basins& basins, int x0, int y0, int x1, int y1) {
  PairCollector pairs(basins);
  const auto w = static_cast<size_t>(basins.index.width);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const size_t i = static_cast<size_t>(y) * w + x;
      if (x + 1 < x1) pairs.add(i, i + 1);
      if (y + 1 < y1) pairs.add(i, i + w);
    }
  return pairs.borders();
}

void measure_basins(const Image8& rgba, const Image8& rgb, Basins& basins) {
  measure_areas(rgba, rgb, basins);
  measure_boxes(basins);
  basins.borders = borders_within(basins, 0, 0, basins.index.width, basins.index.height);
}

}  // namespace relievo
