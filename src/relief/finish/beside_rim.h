#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/segment_grid.h"

namespace relievo::relief {

/// Finds the points of a rim near a place, and extends values at them to the places beside it.
class BesideRim {
 public:
  /// `reach`: canvas px. Precondition: there are points.
  BesideRim(std::vector<Point2> rim, double reach)
      : rim_(std::move(rim)),
        reach_(reach),
        grid_(rim_.size(), [this](size_t i) { return std::pair(rim_[i], rim_[i]); }) {}

  /// Returns how far the rim is looked for, canvas px.
  double reach() const { return reach_; }

  /// Returns the distance to the rim, `reach` at most.
  double distance_to(Point2 place) const {
    double nearest = reach_;
    for (double radius = reach_ / 16; radius <= reach_ && nearest == reach_; radius *= 2)
      for_each_within(place, radius, [&](size_t, double d) { nearest = std::min(nearest, d); });
    return nearest;
  }

  /// Calls visit(index, weight) for the points of the rim beside a place, whose distance `nearest`
  /// from the rim is below `reach`. The weights add up to 1 and vary smoothly with the place.
  template <class Visit>
  void for_each(Point2 place, double nearest, Visit visit) const {
    const double radius = 1.5 * nearest + 1;
    const auto weight = [radius](double d) {
      const double inside = 1 - d / radius;
      return inside * inside / ((d * d + 0.01) * (d * d + 0.01));
    };
    double sum = 0;
    for_each_within(place, radius, [&](size_t, double d) { sum += weight(d); });
    for_each_within(place, radius, [&](size_t i, double d) { visit(i, weight(d) / sum); });
  }

  /// Returns a smooth weight, 1 at distance 0 and 0 at `reach`.
  static double share_within(double distance, double reach) {
    const double t = std::min(1.0, distance / reach);
    return (1 - t * t) * (1 - t * t);
  }

 private:
  /// Calls visit(index, distance) for all points closer to a place than `radius`.
  template <class Visit>
  void for_each_within(Point2 place, double radius, Visit visit) const {
    grid_.for_each_near(place, place, radius, [&](int i) {
      const double d = distance(rim_[i], place);
      if (d < radius) visit(static_cast<size_t>(i), d);
    });
  }

  std::vector<Point2> rim_;
  double reach_;
  SegmentGrid grid_;
};

}  // namespace relievo::relief
