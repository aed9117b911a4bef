#pragma once

#include <vector>

#include "relief/inflation/inflation.h"
#include "support/shift_cost.h"

namespace relievo::testing {

/// How far heights are from the minimiser of the cost of h - f under depth pairs; scene units.
struct DepthOptimality {
  double violation = 0;  ///< worst violation of a pair
  double imbalance = 0;  ///< worst force that no multiplier of the pairs can hold
};

/// Checks the conditions of Karush, Kuhn and Tucker without solving anything: on every set of nodes
/// that touch, the residual forces must be carried by pairs that only push. By the theorem of
/// Gale and Hoffman they are exactly if they add up to 0, and over each subset closed upwards to
/// 0 or more. Exponential in the number of nodes that touch at a vertex.
DepthOptimality check_depth_optimality(const ShiftCost& cost, const relief::Inflation& inflation,
                                       const std::vector<relief::DepthPair>& pairs,
                                       const std::vector<double>& h);

}  // namespace relievo::testing
