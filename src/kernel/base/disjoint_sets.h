#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace relievo {

/// A partition of 0 .. size()-1 into sets (union-find). A set is represented by its smallest
/// member, so results do not depend on the order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(static_cast<size_t>(n)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int size() const { return static_cast<int>(parent_.size()); }

  /// Adds a set with one new member, and returns that member.
  int add() {
    parent_.push_back(size());
    return parent_.back();
  }

  /// Returns the smallest member of the set of i. O(log n) amortised.
  int find(int i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Unites the sets of i and j. O(log n) amortised.
  void unite(int i, int j) {
    const auto [low, high] = std::minmax({find(i), find(j)});
    parent_[high] = low;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace relievo
