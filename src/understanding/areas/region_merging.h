#pragma once

#include <array>
#include <map>
#include <vector>

#include "kernel/base/disjoint_sets.h"
#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// How two regions meet.
struct RegionBorder {
  int64_t pairs = 0;
  int64_t line_pairs = 0;
  int64_t edge_pairs = 0;
  std::array<int64_t, 3> step = {};  ///< see BasinBorder, towards the neighbour
};

/// Basins that are united step by step; a region is known by its smallest basin.
class RegionMerging {
 public:
  explicit RegionMerging(const Basins& basins);

  bool is_region(int r) { return sets_.find(r) == r; }
  int region_of(int basin) { return sets_.find(basin); }
  const Basin& region(int r) const { return regions_[r]; }
  const std::map<int, RegionBorder>& borders(int r) const { return borders_[r]; }
  int count() const { return static_cast<int>(regions_.size()); }  ///< of basins

  /// Unites two regions. O(borders of the one with fewer, log).
  void unite(int a, int b);

  /// Share of the border of two neighbours that nothing marks; an edge between areas of similar
  /// colour is texture and marks nothing, but for the rim of the figure where that is sharp.
  double open_share(int a, int b) const;

  /// From now on edges mark nothing, but for those of areas that are as dark as ink: where ink
  /// outlines the parts, they are what is painted on them.
  void ignore_edges() { edges_count_ = false; }

  /// Euclidean distance of mean colours, of 255 a channel; 0 where one has no colour.
  double colour_distance(int a, int b) const;

  /// The same of the colours beside that part of the border of two neighbours that has neither
  /// line nor edge: small between areas that differ since light changes over both. Where no part
  /// has, that of the means.
  double colour_step(int a, int b) const;

 private:
  bool edges_count_ = true;
  DisjointSets sets_;
  std::vector<Basin> regions_;
  std::vector<std::map<int, RegionBorder>> borders_;
  bool figure_is_sharp_;
};

}  // namespace relievo::understanding
