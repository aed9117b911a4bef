#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "understanding/joins/layer_grid.h"

namespace relievo::understanding {

/// The step along outlines that are tested for being inside other parts, in grid pixels.
constexpr double root_step = 1.5;

/// A run of one ring of a part inside another part.
struct RingRun {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;    ///< arc length where it begins
  double length = 0;  ///< the whole ring's where it does not leave

  Point2 at(double s) const { return point_at(*ring, measure, from + s); }
};

/// Finds all runs of the outer rings of a part inside another, the longest first; a single step
/// outside does not interrupt a run. The outline must outlive the result. O(its length /
/// root_step).
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Outline& outline, int other);

/// The cap of a limb's root, as arc lengths of the run.
struct RootCap {
  double from = 0;
  double to = 0;
};

/// Finds the run along which a limb is best joined, inside the run of its outline in another part:
/// around the limb's tip, with its ends moved to nearby `anchors` of the author (canvas px).
RootCap find_root_cap(const LayerGrid& grid, const RingRun& run, int part, int other,
                      const std::vector<Point2>& anchors);

}  // namespace relievo::understanding
