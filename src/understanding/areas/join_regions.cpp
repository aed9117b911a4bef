#include "understanding/areas/join_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

namespace relievo::understanding {
namespace {

/// What a border with a line all along is worth beside one that is open.
constexpr double line_worth = 0.3;
/// Share of the whole border that a change of colour from black to white is worth.
constexpr double colour_worth = 2;

/// Sums of colours of what has one label.
struct Colour {
  std::array<int64_t, 3> sum = {};
  int64_t pixels = 0;

  void add(const Basin& basin) {
    for (size_t c = 0; c < 3; ++c) sum[c] += basin.colour_sum[c];
    pixels += basin.coloured;
  }
};

/// The largest difference of the channels' means, 0 to 1.
double difference(const Colour& a, const Colour& b) {
  if (a.pixels == 0 || b.pixels == 0) return 0;
  double largest = 0;
  for (size_t c = 0; c < 3; ++c) {
    const double own = static_cast<double>(a.sum[c]) / static_cast<double>(a.pixels);
    const double other = static_cast<double>(b.sum[c]) / static_cast<double>(b.pixels);
    largest = std::max(largest, std::abs(own - other));
  }
  return largest / 255;
}

/// Labels as a graph.
class LabelGraph {
 public:
  LabelGraph(const Basins& basins, int part_count, const std::vector<int>& labels)
      : part_count_(part_count) {
    const size_t count = static_cast<size_t>(part_count + basins.region_count) + 1;
    colours_.resize(count);
    borders_.resize(count);
    joined_.resize(count);
    std::iota(joined_.begin(), joined_.end(), 0);
    for (size_t b = 0; b < labels.size(); ++b) colours_[labels[b]].add(basins.basins[b]);
    for (const BasinBorder& border : basins.borders) {
      const int a = labels[border.a];
      const int b = labels[border.b];
      if (a == b) continue;
      const double open = static_cast<double>(border.pairs - border.line_pairs);
      const double worth = open + line_worth * static_cast<double>(border.line_pairs);
      borders_[a][b] += worth;
      borders_[b][a] += worth;
    }
  }

  /// [labels] the label that each goes to.
  std::vector<int> join() {
    while (join_surest()) {
    }
    return joined_;
  }

 private:
  bool is_scribbled(int label) const { return label > 0 && label <= part_count_; }

  /// Joins the region that most surely belongs to a scribbled part; false where there is none.
  bool join_surest() {
    int region = -1;
    int part = -1;
    double best = 0;
    for (int r = part_count_ + 1; r < static_cast<int>(joined_.size()); ++r) {
      if (joined_[r] != r) continue;
      std::map<int, double> worth;
      double all = 0;
      for (const auto& [other, border] : borders_[r]) {
        all += border;
        if (is_scribbled(joined_[other])) worth[joined_[other]] += border;
      }
      for (const auto& [label, border] : worth) {
        const double sureness =
            border / all - colour_worth * difference(colours_[r], colours_[label]);
        if (region >= 0 && sureness <= best) continue;
        best = sureness;
        region = r;
        part = label;
      }
    }
    if (region >= 0) joined_[region] = part;
    return region >= 0;
  }

  int part_count_;
  std::vector<Colour> colours_;                 ///< [labels] before anything is joined
  std::vector<std::map<int, double>> borders_;  ///< [labels] worth of the border with others
  std::vector<int> joined_;                     ///< [labels]
};

}  // namespace

void join_regions(const Basins& basins, int part_count, std::vector<int>& labels) {
  const std::vector<int> joined = LabelGraph(basins, part_count, labels).join();
  for (int& label : labels) label = joined[label];
}

}  // namespace relievo::understanding
