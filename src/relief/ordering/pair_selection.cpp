#include "relief/ordering/pair_selection.h"

#include <utility>

namespace relievo {
namespace {

/// Whether nodes of one group are so in `wider` too.
bool is_within(const std::vector<int>& group, const std::vector<int>& wider) {
  for (size_t n = 0; n < group.size(); ++n)
    if (wider[n] != wider[group[n]]) return false;
  return true;
}

}  // namespace

bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system) {
  const DepthForest& last = system.problem.forest;
  DepthForest forest = build_depth_forest(node_part, pairs);
  if (!is_within(forest.group, last.group)) return false;
  if (forest.gaps == last.gaps) return true;
  forest.group = last.group;
  GapVariables variables = make_gap_variables(forest);
  set_problem({std::move(forest), std::move(variables)}, metric, system);
  return true;
}

}  // namespace relievo
