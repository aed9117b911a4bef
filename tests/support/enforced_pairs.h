#pragma once

#include <vector>

#include "relief/ordering/depth_forest.h"

namespace relievo::testing {

/// The pairs that the forest enforces; where the given pairs form diamonds they are stronger.
inline std::vector<DepthPair> enforced_pairs(const LayeredMesh& mesh) {
  const DepthForest forest = build_depth_forest(mesh.node_part, mesh.constraints);
  std::vector<DepthPair> pairs;
  for (int n = 0; n < static_cast<int>(forest.representative.size()); ++n)
    if (forest.representative[n] != n) pairs.push_back({forest.representative[n], n, true});
  for (const DepthGap& gap : forest.gaps)
    pairs.push_back(gap.sign > 0 ? DepthPair{gap.parent, gap.child, false}
                                 : DepthPair{gap.child, gap.parent, false});
  return pairs;
}

}  // namespace relievo::testing
