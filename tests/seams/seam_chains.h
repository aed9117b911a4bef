#pragma once

#include <set>
#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::testing {

/// A join on the mesh: a chain of nodes where the faces of the upper part meet those of the parts
/// below.
struct SeamChain {
  int upper = -1;
  std::vector<int> nodes;      ///< from end to end
  std::vector<double> length;  ///< along the chain up to each node, px
};

/// Returns the nodes on outlines of bumps that are not on joins.
std::set<int> loose_rims(const relief::LayeredMesh& mesh);

/// Returns all joins, in the order of their upper parts. Near-linear.
std::vector<SeamChain> seam_chains(const relief::LayeredMesh& mesh);

}  // namespace relievo::testing
