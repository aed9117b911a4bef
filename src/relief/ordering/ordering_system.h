#pragma once

#include <optional>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_contacts.h"
#include "relief/ordering/depth_problem.h"
#include "relief/ordering/stacked_nodes.h"

namespace relievo {

/// What the ordering of one surface leaves behind for the next one on it.
struct OrderingSystem {
  double epsilon = 0;  ///< that of the metric; 0: there is none yet
  ShiftMetric metric;
  StackedNodes stacked;
  std::vector<DepthPair> inside;                ///< stacked nodes that were compared last, sorted
  std::optional<std::vector<DepthPair>> pairs;  ///< that `system` is for now, if there is one
  DepthSystem system;
  /// Where a first solve begins: heights on this mesh, or else contacts on another, or else as the
  /// options say.
  std::vector<double> h;
  std::vector<DepthContact> contacts;
};

}  // namespace relievo
