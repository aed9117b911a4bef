#pragma once

#include <vector>

#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// One part is in front of another.
struct OrderArrow {
  PartLabel upper = 0;
  PartLabel lower = 0;
  double confidence = 0;  ///< in [0, 1]; 1 for the user's
  bool user = false;      ///< given by the user and never dropped; a guess otherwise
  bool kept = true;       ///< false where it was dropped to break a cycle
};

/// The depth order of all parts.
struct Stacking {
  std::vector<PartLabel> back_to_front;
  std::vector<OrderArrow> arrows;  ///< all guesses and the user's, by upper, then lower
};

}  // namespace relievo::understanding
