#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "understanding/joins/roots.h"

namespace relievo::understanding {

/// A run of one ring of a part inside another part.
struct RingRun {
  const Ring* ring = nullptr;
  RingMeasure measure;
  double from = 0;
  double length = 0;  ///< the whole ring's where it does not leave

  Point2 at(double s) const { return point_at(*ring, measure, from + s); }
};

/// All runs of the outer rings of a part inside another, the longest first; single steps outside do
/// not part them. The outline outlives them. O(its length / root_step).
std::vector<RingRun> runs_inside(const LayerGrid& grid, const Outline& outline, int other);

/// The cap of a limb's root, as arc lengths of the run.
struct RootCap {
  double from = 0;
  double to = 0;
};

/// Where on the run of a part's outline inside another its join lies best: around its tip, from
/// anchor to anchor of those who drew it (canvas px) where there are some near the ends.
RootCap find_root_cap(const LayerGrid& grid, const RingRun& run, int part, int other,
                      const std::vector<Point2>& anchors);

}  // namespace relievo::understanding
