#include "kernel/image/components.h"

#include <algorithm>
#include <cassert>

namespace relievo {
namespace {

/// Union-find that grows; the smallest member represents a set.
class ProvisionalLabels {
 public:
  int32_t add() {
    parent_.push_back(static_cast<int32_t>(parent_.size()));
    return parent_.back();
  }

  int32_t find(int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  int32_t unite(int32_t i, int32_t j) {
    const auto [low, high] = std::minmax({find(i), find(j)});
    return parent_[high] = low;
  }

  /// Numbers the sets without gaps, in place; afterwards [i] is the number of i's set.
  int32_t renumber() {
    int32_t count = 0;
    for (size_t i = 1; i < parent_.size(); ++i)
      parent_[i] = parent_[i] == static_cast<int32_t>(i) ? ++count : parent_[parent_[i]];
    return count;
  }

  int32_t number(int32_t i) const { return parent_[i]; }

 private:
  std::vector<int32_t> parent_ = {0};
};

/// Labels the pixel from those of its neighbours before it, uniting them where they differ.
int32_t label_of(const Image<int32_t>& label, int x, int y, Connectivity connectivity,
                 ProvisionalLabels& sets) {
  int32_t found = 0;
  const auto join = [&](int nx, int ny) {
    if (nx < 0 || ny < 0 || nx >= label.width) return;
    const int32_t other = label.at(nx, ny);
    if (other == 0 || other == found) return;
    found = found == 0 ? other : sets.unite(found, other);
  };
  join(x - 1, y);
  join(x, y - 1);
  if (connectivity == Connectivity::corners) {
    join(x - 1, y - 1);
    join(x + 1, y - 1);
  }
  return found != 0 ? found : sets.add();
}

}  // namespace

Components connected_components(const Image8& mask, Connectivity connectivity) {
  assert(mask.channels == 1);
  Components result{Image<int32_t>(mask.width, mask.height, 1), {}};
  ProvisionalLabels sets;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0)
        result.label.at(x, y) = label_of(result.label, x, y, connectivity, sets);
  result.areas.assign(static_cast<size_t>(sets.renumber()) + 1, 0);
  for (int32_t& label : result.label.pixels) ++result.areas[label = sets.number(label)];
  return result;
}

}  // namespace relievo
