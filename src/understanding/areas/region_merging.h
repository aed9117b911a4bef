#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/base/disjoint_sets.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// The region adjacency graph of basins that are united step by step. A region is known by its
/// smallest basin.
class RegionMerging {
 public:
  explicit RegionMerging(const Basins& basins);

  bool is_region(int r) { return sets_.find(r) == r; }
  int region_of(int basin) { return sets_.find(basin); }
  const Basin& region(int r) const { return regions_[r]; }
  /// Returns the neighbours of a region; `step` leads from the region to the neighbour.
  const std::map<int, Border>& borders(int r) const { return borders_[r]; }
  int count() const { return static_cast<int>(regions_.size()); }  ///< of basins

  /// Sums all borders of a region. O(its borders).
  Border whole_border(int r) const;

  /// Unites two regions and returns the united one. O(borders of the one with fewer, log).
  int unite(int a, int b);

  /// Computes the Euclidean distance of the mean colours close to the border, of 255 a channel. It
  /// is small between areas that differ since light changes across both.
  double colour_step(int a, int b) const;

 private:
  DisjointSets sets_;
  std::vector<Basin> regions_;
  std::vector<std::map<int, Border>> borders_;
};

/// Unites neighbouring regions in the order of their worth, the greatest first.
class Merger {
 public:
  /// Returns the worth of uniting two neighbours. Where it is negative they stay apart.
  using Worth = std::function<double(int, int)>;

  /// Two united regions, by their smallest basins, a < b; now they are region a.
  struct Union {
    double worth = 0;
    int a = 0;
    int b = 0;
    friend bool operator<(const Union& p, const Union& q) {
      return std::tie(p.worth, p.a, p.b) < std::tie(q.worth, q.a, q.b);
    }
  };

  Merger(RegionMerging& regions, Worth worth);

  /// Unites the next two regions; nothing where all stay apart. O(borders of both, log).
  std::optional<Union> unite_next();

 private:
  void propose(int a, int b);

  RegionMerging& regions_;
  Worth worth_;
  std::priority_queue<Union> queue_;
};

}  // namespace relievo::understanding
