#include "understanding/areas/region_merging.h"

#include <algorithm>
#include <cmath>

namespace relievo::understanding {
namespace {

/// Returns a border as seen from its other side.
Border turned(Border border) {
  for (int64_t& step : border.step) step = -step;
  return border;
}

}  // namespace

RegionMerging::RegionMerging(const Basins& basins)
    : sets_(static_cast<int>(basins.basins.size())),
      regions_(basins.basins),
      borders_(basins.basins.size()) {
  for (const BasinBorder& border : basins.borders) {
    borders_[border.a][border.b] = border;
    borders_[border.b][border.a] = turned(border);
  }
}

Border RegionMerging::whole_border(int r) const {
  Border sum;
  for (const auto& [neighbour, border] : borders_[r]) sum.add(border);
  return sum;
}

int RegionMerging::unite(int a, int b) {
  const auto [keeps, goes] = std::minmax(a, b);
  sets_.unite(a, b);
  Basin& region = regions_[keeps];
  const Basin& other = regions_[goes];
  region.area += other.area;
  region.inradius = std::max(region.inradius, other.inradius);
  region.coloured += other.coloured;
  region.figure += other.figure;
  region.transparent += other.transparent;
  region.colour_squares += other.colour_squares;
  region.box.add(other.box);
  for (size_t k = 0; k < 4; ++k) region.at_edge[k] += other.at_edge[k];
  for (size_t c = 0; c < 3; ++c) region.colour_sum[c] += other.colour_sum[c];

  if (borders_[goes].size() > borders_[keeps].size()) std::swap(borders_[goes], borders_[keeps]);
  borders_[keeps].erase(keeps);
  borders_[keeps].erase(goes);
  for (const auto& [neighbour, border] : borders_[goes])
    if (neighbour != keeps && neighbour != goes) borders_[keeps][neighbour].add(border);
  borders_[goes].clear();
  for (const auto& [neighbour, border] : borders_[keeps]) {
    borders_[neighbour].erase(goes);
    borders_[neighbour][keeps] = turned(border);
  }
  return keeps;
}

double RegionMerging::colour_step(int a, int b) const {
  const Border& border = borders_[a].at(b);
  double sum = 0;
  for (const int64_t step : border.step)
    sum += static_cast<double>(step) * static_cast<double>(step);
  return std::sqrt(sum) / static_cast<double>(border.pairs);
}

Merger::Merger(RegionMerging& regions, Worth worth) : regions_(regions), worth_(std::move(worth)) {
  for (int a = 0; a < regions.count(); ++a)
    for (const auto& [b, border] : regions.borders(a))
      if (a < b) propose(a, b);
}

std::optional<Merger::Union> Merger::unite_next() {
  while (!queue_.empty()) {
    const Union next = queue_.top();
    queue_.pop();
    // An entry that a later union has made out of date was pushed again with its new worth.
    if (!regions_.is_region(next.a) || !regions_.is_region(next.b) ||
        regions_.borders(next.a).count(next.b) == 0 || worth_(next.a, next.b) != next.worth)
      continue;
    regions_.unite(next.a, next.b);
    for (const auto& [neighbour, border] : regions_.borders(next.a)) propose(next.a, neighbour);
    return next;
  }
  return std::nullopt;
}

void Merger::propose(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  const double worth = worth_(a, b);
  if (worth >= 0) queue_.push({worth, low, high});
}

}  // namespace relievo::understanding
