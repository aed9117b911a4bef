#include "understanding/areas/region_merging.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo::understanding {
namespace {

constexpr double similar_colour = 60;  ///< distance of mean colours, of 255 a channel
constexpr double darkest_paint = 48;   ///< mean of a channel, of 255

bool is_as_dark_as_ink(const Basin& region) {
  const auto most =
      static_cast<double>(*std::max_element(region.colour_sum.begin(), region.colour_sum.end()));
  return region.coloured > 0 && most < darkest_paint * static_cast<double>(region.coloured);
}

RegionBorder from_beyond(RegionBorder border) {
  for (int64_t& step : border.step) step = -step;
  return border;
}

}  // namespace

RegionMerging::RegionMerging(const Basins& basins)
    : sets_(static_cast<int>(basins.basins.size())),
      regions_(basins.basins),
      borders_(basins.basins.size()),
      figure_is_sharp_(basins.figure.sharp) {
  for (const BasinBorder& border : basins.borders) {
    const RegionBorder seen = {border.pairs, border.line_pairs, border.edge_pairs, border.step};
    borders_[border.a][border.b] = seen;
    borders_[border.b][border.a] = from_beyond(seen);
  }
}

void RegionMerging::unite(int a, int b) {
  const auto [keeps, goes] = std::minmax(a, b);
  sets_.unite(a, b);
  Basin& region = regions_[keeps];
  const Basin& other = regions_[goes];
  region.area += other.area;
  region.inradius = std::max(region.inradius, other.inradius);
  region.coloured += other.coloured;
  region.transparent += other.transparent;
  region.in_figure += other.in_figure;
  region.box.add(other.box);
  for (size_t k = 0; k < 4; ++k) region.at_edge[k] += other.at_edge[k];
  for (size_t c = 0; c < 3; ++c) region.colour_sum[c] += other.colour_sum[c];

  if (borders_[goes].size() > borders_[keeps].size()) std::swap(borders_[goes], borders_[keeps]);
  borders_[keeps].erase(keeps);
  borders_[keeps].erase(goes);
  for (const auto& [neighbour, border] : borders_[goes]) {
    if (neighbour == keeps || neighbour == goes) continue;
    RegionBorder& sum = borders_[keeps][neighbour];
    sum.pairs += border.pairs;
    sum.line_pairs += border.line_pairs;
    sum.edge_pairs += border.edge_pairs;
    for (size_t c = 0; c < 3; ++c) sum.step[c] += border.step[c];
  }
  borders_[goes].clear();
  for (const auto& [neighbour, border] : borders_[keeps]) {
    borders_[neighbour].erase(goes);
    borders_[neighbour][keeps] = from_beyond(border);
  }
}

double RegionMerging::open_share(int a, int b) const {
  if (figure_is_sharp_ && is_in_figure(regions_[a]) != is_in_figure(regions_[b])) return 0;
  const RegionBorder& border = borders_[a].at(b);
  const bool marked =
      (edges_count_ || is_as_dark_as_ink(regions_[a]) || is_as_dark_as_ink(regions_[b])) &&
      colour_distance(a, b) >= similar_colour;
  const int64_t edges = marked ? border.edge_pairs : 0;
  return 1 - static_cast<double>(border.line_pairs + edges) / static_cast<double>(border.pairs);
}

double RegionMerging::colour_step(int a, int b) const {
  const RegionBorder& border = borders_[a].at(b);
  const int64_t open = border.pairs - border.line_pairs - border.edge_pairs;
  if (open == 0) return colour_distance(a, b);
  double sum = 0;
  for (const int64_t step : border.step)
    sum += static_cast<double>(step) * static_cast<double>(step);
  return std::sqrt(sum) / static_cast<double>(open);
}

double RegionMerging::colour_distance(int a, int b) const {
  const Basin& x = regions_[a];
  const Basin& y = regions_[b];
  if (x.coloured == 0 || y.coloured == 0) return 0;
  double sum = 0;
  for (size_t c = 0; c < 3; ++c) {
    const double difference =
        static_cast<double>(x.colour_sum[c]) / static_cast<double>(x.coloured) -
        static_cast<double>(y.colour_sum[c]) / static_cast<double>(y.coloured);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace relievo::understanding
