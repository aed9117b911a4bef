#pragma once

#include <algorithm>
#include <limits>

#include "relievo/point.h"

namespace relievo {

/// An axis-aligned box in space; empty while max < min.
struct Box3 {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 min{infinity, infinity, infinity};
  Point3 max{-infinity, -infinity, -infinity};

  void add(Point3 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
  Point3 sides() const { return max - min; }
};

}  // namespace relievo
