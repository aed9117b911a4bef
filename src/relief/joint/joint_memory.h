#pragma once

#include <vector>

#include "kernel/geometry/point.h"

namespace relievo {

/// What an iteration knew of one node where parts press on each other, or on B.
struct JointMark {
  int part = -1;
  Point2 position;   ///< px
  double rise = 0;   ///< u beyond that of the start, scene units
  double slope = 0;  ///< on B: of the inflation energy, per length of outline
  double load = 0;   ///< per root of the node's mass
  double h = 0;      ///< px
};

/// Where an iteration ended, for another to begin from, on the same mesh or one of a similar
/// scene. Sorted by part and position.
using JointMemory = std::vector<JointMark>;

}  // namespace relievo
