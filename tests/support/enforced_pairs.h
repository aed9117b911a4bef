#pragma once

#include <vector>

#include "relief/ordering/depth_forest.h"

namespace relievo::testing {

/// The pairs that the forest enforces; where the given pairs form diamonds they are stronger.
inline std::vector<DepthPair> enforced_pairs(const LayeredMesh& mesh) {
  const DepthForest forest = build_depth_forest(mesh.node_part, mesh.constraints);
  std::vector<DepthPair> pairs;
  for (const DepthGap& gap : forest.gaps)
    pairs.push_back(gap.sign > 0 ? DepthPair{gap.parent, gap.child, gap.equal}
                                 : DepthPair{gap.child, gap.parent, gap.equal});
  return pairs;
}

}  // namespace relievo::testing
