#pragma once

#include <vector>

namespace relievo::understanding {

enum class OrderSource {
  guess,  ///< from shapes and contours
  user,   ///< said by the user; never given up
};

/// One part is in front of another.
struct OrderArrow {
  int upper = -1;
  int lower = -1;
  double confidence = 0;  ///< in [0, 1]; 1 for the user's
  OrderSource source = OrderSource::guess;
  bool kept = true;  ///< false where it was given up to break a cycle
};

/// The order of depth of all parts.
struct Stacking {
  std::vector<int> back_to_front;  ///< parts
  std::vector<int> rank;           ///< per part, its place in back_to_front
  std::vector<OrderArrow> arrows;  ///< all that was guessed and said; by upper, then lower
};

}  // namespace relievo::understanding
