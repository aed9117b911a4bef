#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "rivals/seam_chains.h"

namespace relievo::testing {

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
