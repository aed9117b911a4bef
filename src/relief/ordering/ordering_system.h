#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_contacts.h"
#include "relief/ordering/depth_problem.h"

namespace relievo {

/// What the ordering of one surface leaves behind for the next one on it.
struct OrderingSystem {
  /// The last solve of each cutting-plane round.
  struct Round {
    std::vector<DepthPair> pairs;
    DepthSystem system;
  };

  /// Whether all rounds are kept, and begin from their last solutions where their pairs are still
  /// the same. Otherwise memory holds one of them at a time.
  bool keep_rounds = false;
  double epsilon = 0;  ///< that of the metric; 0: there is none yet
  ShiftMetric metric;
  std::vector<Round> rounds;
  /// Where a first round begins: heights on this mesh, or else contacts on another, or else as the
  /// options say.
  std::vector<double> h;
  std::vector<DepthContact> contacts;
};

}  // namespace relievo
