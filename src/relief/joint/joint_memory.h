#pragma once

#include <vector>

#include "kernel/geometry/point.h"
#include "relief/ordering/depth_contacts.h"

namespace relievo {

/// What an iteration knew of one node where parts press on each other, or on B.
struct JointMark {
  int part = -1;
  Point2 position;            ///< px
  bool on_outline = false;    ///< or on B
  double rise = 0;            ///< u beyond that of the start, scene units
  double load = 0;            ///< with which the pairs change u, scene units
  std::vector<double> modes;  ///< on B: its change of f in each of the memory's modes

  int group() const { return part; }
};

/// Where an iteration ended, for another to begin from, on the same mesh or one of a similar
/// scene.
struct JointMemory {
  std::vector<JointMark> marks;  ///< by group and position
  std::vector<DepthContact> contacts;
  std::vector<double> mode_stiffness;  ///< of the modes of B, as `BoundModes` has it
};

/// After a change of the parts' numbers.
void sort_marks(std::vector<JointMark>& marks);

}  // namespace relievo
