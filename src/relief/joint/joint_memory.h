#pragma once

#include <utility>
#include <vector>

#include "kernel/geometry/point.h"

namespace relievo {

/// What an iteration knew of one node where parts press on each other, or on B.
struct JointMark {
  int part = -1;
  Point2 position;  ///< px
  double rise = 0;  ///< u beyond that of the start, scene units
  double load = 0;  ///< with which the pairs change u, scene units
  double h = 0;     ///< px

  int group() const { return part; }
};

/// Where two parts touched inside of their outlines.
struct InnerContact {
  int lower = -1;  ///< parts
  int upper = -1;
  Point2 position;   ///< px
  double reach = 0;  ///< px, the longest edge there

  std::pair<int, int> group() const { return {lower, upper}; }
};

/// Where an iteration ended, for another to begin from, on the same mesh or one of a similar
/// scene. Both are sorted by group and position.
struct JointMemory {
  std::vector<JointMark> marks;
  std::vector<InnerContact> contacts;
};

/// After a change of the parts' numbers.
void sort_memory(JointMemory& memory);

}  // namespace relievo
