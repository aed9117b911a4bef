#pragma once

#include <set>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::testing {

/// A join as it lies on the mesh: a chain of nodes on which the faces of the upper part and of
/// those below it meet.
struct SeamChain {
  int upper = -1;
  std::vector<int> nodes;      ///< from end to end
  std::vector<double> length;  ///< along the chain up to each node, px
};

/// The nodes of bumps' outlines that are not on joins.
std::set<int> loose_rims(const relief::LayeredMesh& mesh);

/// All joins, in the order of their upper parts. Near-linear.
std::vector<SeamChain> seam_chains(const relief::LayeredMesh& mesh);

}  // namespace relievo::testing
