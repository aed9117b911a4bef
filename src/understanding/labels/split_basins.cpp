#include "understanding/labels/split_basins.h"

#include <algorithm>
#include <cmath>

#include "kernel/image/distance_transform.h"
#include "kernel/image/watershed.h"
#include "understanding/areas/basin_graph.h"

namespace relievo::understanding {
namespace {

using HardPixels = std::vector<BasinVotes::HardPixel>;

/// Returns the end of the run of hard pixels in one basin that begins at `begin`.
size_t end_of_basin(const HardPixels& hard, size_t begin) {
  size_t end = begin;
  while (end < hard.size() && hard[end].basin == hard[begin].basin) ++end;
  return end;
}

std::set<int> labels_of(const HardPixels& hard, size_t begin, size_t end) {
  std::set<int> labels;
  for (size_t k = begin; k < end; ++k) labels.insert(hard[k].label);
  return labels;
}

/// A window of the image around one basin.
struct Window {
  int x0, y0, x1, y1;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

Window window_of(const Basins& basins, int basin) {
  const Box2& box = basins.basins[basin].box;
  return {std::max(0, static_cast<int>(box.min.x) - 1),
          std::max(0, static_cast<int>(box.min.y) - 1),
          std::min(basins.index.width, static_cast<int>(box.max.x) + 1),
          std::min(basins.index.height, static_cast<int>(box.max.y) + 1)};
}

/// Computes heights for a flood inside a window: 0 at the largest distance to lines, 254 next to
/// lines, and 255 on them.
Image8 narrowness(const Basins& basins, const Window& window) {
  Image8 barrier(window.width(), window.height(), 1);
  for (int y = 0; y < barrier.height; ++y)
    for (int x = 0; x < barrier.width; ++x)
      barrier.at(x, y) = basins.barrier.at(window.x0 + x, window.y0 + y);
  const Image<int32_t> squared = squared_distance_to(barrier);
  double widest = 1;
  for (const int32_t s : squared.pixels)
    if (s != no_distance) widest = std::max(widest, std::sqrt(static_cast<double>(s)));
  Image8 height(window.width(), window.height(), 1);
  for (size_t i = 0; i < height.pixels.size(); ++i) {
    const double distance = std::sqrt(static_cast<double>(squared.pixels[i]));
    height.pixels[i] = static_cast<uint8_t>(
        barrier.pixels[i] != 0 ? 255 : 254 * (1 - std::min(1.0, distance / widest)));
  }
  return height;
}

/// Gives each hard label of one basin its own basin. The first keeps the number.
void split_one(Basins& basins, HardPixels& hard, size_t begin, size_t end) {
  const int basin = hard[begin].basin;
  const Window window = window_of(basins, basin);
  const std::set<int> labels = labels_of(hard, begin, end);
  std::map<int, int> basin_of_label;
  for (const int label : labels) {
    const bool first = basin_of_label.empty();
    basin_of_label[label] = first ? basin : static_cast<int>(basins.basins.size());
    if (first) continue;
    basins.basins.push_back(basins.basins[basin]);
    basins.region.push_back(basins.region[basin]);
  }
  Image<int32_t> seeds(window.width(), window.height(), 1);
  for (int y = 0; y < seeds.height; ++y)
    for (int x = 0; x < seeds.width; ++x)
      seeds.at(x, y) = basins.index.at(window.x0 + x, window.y0 + y) == basin ? 0 : -1;
  for (size_t k = begin; k < end; ++k) {
    hard[k].basin = basin_of_label[hard[k].label];
    seeds.at(hard[k].pixel % basins.index.width - window.x0,
             hard[k].pixel / basins.index.width - window.y0) = hard[k].basin + 1;
  }
  flood_from_seeds(narrowness(basins, window), seeds);
  for (int y = 0; y < seeds.height; ++y)
    for (int x = 0; x < seeds.width; ++x)
      if (seeds.at(x, y) > 0) basins.index.at(window.x0 + x, window.y0 + y) = seeds.at(x, y) - 1;
}

/// Measures the borders of the pieces of a basin, which lies in the window, again.
void renew_borders(Basins& basins, const std::set<int>& pieces, const Window& window) {
  const auto touches = [&](const BasinBorder& border) {
    return pieces.count(border.a) + pieces.count(border.b) > 0;
  };
  basins.borders.erase(std::remove_if(basins.borders.begin(), basins.borders.end(), touches),
                       basins.borders.end());
  for (const BasinBorder& border :
       borders_within(basins, window.x0, window.y0, window.x1, window.y1))
    if (touches(border)) basins.borders.push_back(border);
  std::sort(basins.borders.begin(), basins.borders.end(),
            [](const BasinBorder& x, const BasinBorder& y) {
              return x.a != y.a ? x.a < y.a : x.b < y.b;
            });
}

}  // namespace

bool needs_split(const BasinVotes& votes) {
  for (size_t k = 0; k + 1 < votes.hard.size(); ++k)
    if (votes.hard[k].basin == votes.hard[k + 1].basin &&
        votes.hard[k].label != votes.hard[k + 1].label)
      return true;
  return false;
}

Basins split_basins(Basins basins, BasinVotes& votes) {
  for (size_t begin = 0; begin < votes.hard.size();) {
    const size_t end = end_of_basin(votes.hard, begin);
    if (labels_of(votes.hard, begin, end).size() > 1) {
      const Window window = window_of(basins, votes.hard[begin].basin);
      std::set<int> pieces = {votes.hard[begin].basin};
      const size_t count = basins.basins.size();
      split_one(basins, votes.hard, begin, end);
      for (size_t b = count; b < basins.basins.size(); ++b) pieces.insert(static_cast<int>(b));
      renew_borders(basins, pieces, window);
    }
    begin = end;
  }
  votes.soft.resize(basins.basins.size());
  return basins;
}

}  // namespace relievo::understanding
