#include "relief/ordering/pair_selection.h"

#include <cstdint>
#include <utility>

namespace relievo {
namespace {

/// Finds the gaps of a problem by their nodes.
class GapFinder {
 public:
  explicit GapFinder(const DepthProblem& problem)
      : problem_(problem), above_(problem.variables.bounded.size(), -1) {
    for (size_t g = 0; g < problem.forest.gaps.size(); ++g)
      above_[variable(problem.forest.gaps[g].child)] = static_cast<int>(g);
  }

  /// The variable of the gap between the same nodes in the same direction, or -1.
  int variable_like(const DepthGap& gap) const {
    if (is_gap(gap.parent, gap.child, gap.sign)) return variable(gap.child);
    if (is_gap(gap.child, gap.parent, -gap.sign)) return variable(gap.parent);
    return -1;
  }

 private:
  int variable(int node) const { return problem_.variables.variable[node]; }

  bool is_gap(int parent, int child, int sign) const {
    const int g = above_[variable(child)];
    if (g < 0) return false;
    const DepthGap& gap = problem_.forest.gaps[g];
    return gap.parent == parent && gap.child == child && gap.sign == sign;
  }

  const DepthProblem& problem_;
  std::vector<int> above_;  ///< gap of each variable, -1 at roots
};

}  // namespace

bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  DepthSystem& system) {
  const DepthForest forest = build_depth_forest(node_part, pairs);
  if (forest.representative != system.problem.forest.representative) return false;
  const GapFinder finder(system.problem);
  std::vector<uint8_t> bounded(system.qp.bounded.size(), 0);
  for (const DepthGap& gap : forest.gaps) {
    const int variable = finder.variable_like(gap);
    if (variable < 0) return false;
    bounded[variable] = 1;
  }
  system.qp.bounded = std::move(bounded);
  return true;
}

}  // namespace relievo
