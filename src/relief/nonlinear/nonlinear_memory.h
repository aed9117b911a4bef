#pragma once

#include <vector>

#include "relief/ordering/depth_contacts.h"
#include "relievo/point.h"

namespace relievo {

/// What an iteration knew of one node where parts press on each other, or on B.
struct NonlinearMark {
  int part = -1;
  Point2 position;          ///< px
  bool on_outline = false;  ///< or on B
  double rise = 0;          ///< u beyond that of the start, scene units
  double load = 0;          ///< with which the pairs change u, scene units

  int group() const { return part; }
};

/// Where an iteration ended, for another to begin from, on the same mesh or one of a similar
/// scene.
struct NonlinearMemory {
  std::vector<NonlinearMark> marks;  ///< by group and position
  std::vector<DepthContact> contacts;
};

}  // namespace relievo
