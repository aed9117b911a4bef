#include "understanding/areas/join_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace relievo::understanding {
namespace {

constexpr double line_worth = 0.3;  ///< worth of a border with a line all along; open: 1
/// Share of the whole border that a difference of colour from black to white outweighs.
constexpr double colour_worth = 2;

/// [labels][labels] worth of the border with other labels, in pixel pairs.
using LabelBorders = std::vector<std::map<int, double>>;

/// Computes the largest difference of the mean colours' channels, 0 to 1.
double difference(const Basin& a, const Basin& b) {
  if (a.coloured == 0 || b.coloured == 0) return 0;
  const std::array<double, 3> own = mean_colour(a);
  const std::array<double, 3> other = mean_colour(b);
  double largest = 0;
  for (size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(own[c] - other[c]));
  return largest / 255;
}

LabelBorders borders_of(const Basins& basins, const std::vector<int>& labels, size_t count) {
  LabelBorders borders(count);
  for (const BasinBorder& border : basins.borders) {
    const int a = labels[border.a];
    const int b = labels[border.b];
    if (a == b) continue;
    const double open = static_cast<double>(border.pairs - border.line_pairs);
    const double worth = open + line_worth * static_cast<double>(border.line_pairs);
    borders[a][b] += worth;
    borders[b][a] += worth;
  }
  return borders;
}

/// Sums the colours of every label.
std::vector<Basin> colours_of(const Basins& basins, const std::vector<int>& labels, size_t count) {
  std::vector<Basin> colours(count);
  for (size_t b = 0; b < labels.size(); ++b) {
    Basin& sum = colours[labels[b]];
    for (size_t c = 0; c < 3; ++c) sum.colour_sum[c] += basins.basins[b].colour_sum[c];
    sum.coloured += basins.basins[b].coloured;
  }
  return colours;
}

/// Joins the region that most surely belongs to a scribbled part:
///   sureness = share of its border along the part - colour_worth * difference of their colours.
/// Returns false where no region is left that touches one. `joined`: [labels] the label that each
/// has joined, at first itself.
bool join_surest(const LabelBorders& borders, const std::vector<Basin>& colours, int part_count,
                 std::vector<int>& joined) {
  int region = -1;
  int part = -1;
  double best = 0;
  for (int r = part_count + 1; r < static_cast<int>(joined.size()); ++r) {
    if (joined[r] != r) continue;
    std::map<int, double> worth;
    double all = 0;
    for (const auto& [other, border] : borders[r]) {
      all += border;
      const int label = joined[other];
      if (label > 0 && label <= part_count) worth[label] += border;
    }
    for (const auto& [label, border] : worth) {
      const double sureness = border / all - colour_worth * difference(colours[r], colours[label]);
      if (region >= 0 && sureness <= best) continue;
      best = sureness;
      region = r;
      part = label;
    }
  }
  if (region >= 0) joined[region] = part;
  return region >= 0;
}

}  // namespace

void join_regions(const Basins& basins, int part_count, std::vector<int>& labels) {
  const size_t count = static_cast<size_t>(part_count + basins.region_count) + 1;
  const LabelBorders borders = borders_of(basins, labels, count);
  const std::vector<Basin> colours = colours_of(basins, labels, count);
  std::vector<int> joined(count);
  std::iota(joined.begin(), joined.end(), 0);
  while (join_surest(borders, colours, part_count, joined)) {
  }
  for (int& label : labels) label = joined[label];
}

}  // namespace relievo::understanding
