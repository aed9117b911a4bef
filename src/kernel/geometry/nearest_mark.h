#pragma once

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

#include "kernel/geometry/point.h"

namespace relievo {

/// A place on the canvas that is only compared with those of its group.
template <class Mark>
auto mark_key(const Mark& mark) {
  return std::tuple(mark.group(), mark.position.x, mark.position.y);
}

/// The mark nearest to `place` of those in its group that `accept` takes, the first of them that
/// the search meets, or null where there is none. `marks` rise by mark_key. O(log marks) where
/// marks are not stacked above each other on the canvas and most near ones are accepted.
template <class Mark, class Accept>
const Mark* nearest_mark(const std::vector<Mark>& marks, const Mark& place, const Accept& accept) {
  const auto at =
      std::lower_bound(marks.begin(), marks.end(), place,
                       [](const Mark& a, const Mark& b) { return mark_key(a) < mark_key(b); });
  double least = std::numeric_limits<double>::infinity();
  const Mark* best = nullptr;
  const auto look = [&](const Mark& mark) {
    const Point2 offset = mark.position - place.position;
    if (mark.group() != place.group() || offset.x * offset.x >= least) return false;
    if (dot(offset, offset) < least && accept(mark)) {
      least = dot(offset, offset);
      best = &mark;
    }
    return true;
  };
  for (auto right = at; right != marks.end() && look(*right);) ++right;
  for (auto left = at; left != marks.begin() && look(*(left - 1));) --left;
  return best;
}

/// The same of all marks.
template <class Mark>
const Mark* nearest_mark(const std::vector<Mark>& marks, const Mark& place) {
  return nearest_mark(marks, place, [](const Mark&) { return true; });
}

}  // namespace relievo
