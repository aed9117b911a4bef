#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// Returns the sort key of a mark, a value with a `position` on the canvas and a group(). Marks are
/// only compared with those of their group.
template <class Mark>
auto mark_key(const Mark& mark) {
  return std::tuple(mark.group(), mark.position.x, mark.position.y);
}

/// Sorts marks by mark_key; marks with equal keys keep their order. O(n log n).
template <class Mark>
void sort_marks(std::vector<Mark>& marks) {
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return mark_key(a) < mark_key(b); });
}

/// Finds the mark nearest to `place` among those of its group for which accept(mark) is true. Of
/// several at one distance returns the first that the search meets; null where there is none.
/// Precondition: `marks` are sorted by mark_key. O(log marks) where few marks share an x and most
/// near ones are accepted.
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

/// Finds the nearest of all marks of the group.
template <class Mark>
const Mark* nearest_mark(const std::vector<Mark>& marks, const Mark& place) {
  return nearest_mark(marks, place, [](const Mark&) { return true; });
}

/// Two marks on opposite sides of a place.
template <class Mark>
struct MarksBeside {
  const Mark* near = nullptr;    ///< the nearest mark
  const Mark* beyond = nullptr;  ///< the nearest one on the other side of the place, or `near`
  double share = 0;              ///< position of the place between `near` (0) and `beyond` (1)
};

/// Finds the marks on both sides of `place` among those of its group for which accept(mark) is
/// true; nothing where there is none. Precondition and cost as for nearest_mark.
template <class Mark, class Accept>
std::optional<MarksBeside<Mark>> marks_beside(const std::vector<Mark>& marks, const Mark& place,
                                              const Accept& accept) {
  const Mark* near = nearest_mark(marks, place, accept);
  if (near == nullptr) return std::nullopt;
  const Point2 offset = place.position - near->position;
  const double distance = std::sqrt(dot(offset, offset));
  if (distance == 0) return MarksBeside<Mark>{near, near, 0};
  const Mark* beyond = nearest_mark(marks, place, [&](const Mark& mark) {
    return accept(mark) && dot(mark.position - place.position, offset) > 0;
  });
  if (beyond == nullptr) return MarksBeside<Mark>{near, near, 0};
  const Point2 rest = beyond->position - place.position;
  return MarksBeside<Mark>{near, beyond, distance / (distance + std::sqrt(dot(rest, rest)))};
}

}  // namespace relievo
