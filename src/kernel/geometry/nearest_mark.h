#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "relievo/point.h"

namespace relievo {

/// A place on the canvas that is only compared with those of its group.
template <class Mark>
auto mark_key(const Mark& mark) {
  return std::tuple(mark.group(), mark.position.x, mark.position.y);
}

/// By mark_key; marks of one place keep their order.
template <class Mark>
void sort_marks(std::vector<Mark>& marks) {
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return mark_key(a) < mark_key(b); });
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

/// Two marks with a place between them.
template <class Mark>
struct MarksBeside {
  const Mark* near = nullptr;    ///< the nearest one
  const Mark* beyond = nullptr;  ///< the nearest one on the other side of the place, `near` if none
  double share = 0;              ///< of the way from `near` to `beyond`, 0 to 1
};

/// The marks next to `place` among those that `accept` takes, or nothing where there is none.
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
