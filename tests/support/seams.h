#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relievo/point.h"

namespace relievo::testing {

/// A join as it lies on the mesh: a chain of nodes on which the faces of the upper part and of
/// those below it meet.
struct SeamChain {
  int upper = -1;
  std::vector<int> nodes;      ///< from end to end
  std::vector<double> length;  ///< along the chain up to each node, px
};

/// All joins, in the order of their upper parts. Near-linear.
std::vector<SeamChain> seam_chains(const LayeredMesh& mesh);

/// For the nodes of the middle half of the chain the angle between the two sides' normals, degrees:
/// of flat faces, weighted by area. Only nodes that are seen from the front, three edges off all
/// outlines, which are creases.
std::vector<double> seam_angles(const LayeredMesh& mesh, const std::vector<double>& h,
                                const SeamChain& chain);

/// The depth of the pits at the ends of the chain, first and last, relative to its length: how high
/// water would stand on the surface that is seen from the front, within a quarter of the length
/// around each end, if it ran off at half of the length; 0 at ends that are not seen. With -h the
/// height of bumps.
std::vector<double> pits(const LayeredMesh& mesh, const std::vector<double>& h,
                         const SeamChain& chain);

}  // namespace relievo::testing
