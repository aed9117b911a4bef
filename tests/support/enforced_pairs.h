#pragma once

#include <vector>

#include "relief/ordering/depth_forest.h"

namespace relievo::testing {

/// The pairs that the forest enforces; where the given pairs form diamonds they are stronger.
inline std::vector<relief::DepthPair> enforced_pairs(const relief::LayeredMesh& mesh) {
  const relief::DepthForest forest = relief::build_depth_forest(mesh.node_part, mesh.constraints);
  std::vector<relief::DepthPair> pairs;
  for (const relief::DepthGap& gap : forest.gaps)
    pairs.push_back(gap.sign > 0 ? relief::DepthPair{gap.parent, gap.child, gap.equal}
                                 : relief::DepthPair{gap.child, gap.parent, gap.equal});
  return pairs;
}

}  // namespace relievo::testing
