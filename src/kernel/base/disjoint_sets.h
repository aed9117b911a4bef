#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace relievo {

/// Union-find over 0 .. size()-1. The representative of a set is its smallest member, so results do
/// not depend on the order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(static_cast<size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int size() const { return static_cast<int>(parent_.size()); }

  /// Adds a member, alone in its set, and returns it.
  int add() {
    parent_.push_back(size());
    return parent_.back();
  }

  /// Smallest member of the set of i. O(log n) amortised.
  int find(int i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void unite(int i, int j) {
    const auto [low, high] = std::minmax({find(i), find(j)});
    parent_[high] = low;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace relievo
