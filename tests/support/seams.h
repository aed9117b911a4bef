#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/session/build_relief.h"
#include "relievo/scene.h"
#include "seams/seam_chains.h"

namespace relievo::testing {

/// For the nodes of the middle half of the chain the angle between the two sides' normals, degrees:
/// of flat faces, weighted by area. Only nodes that are seen from the front, three edges off all
/// outlines, which are creases.
std::vector<double> seam_angles(const relief::LayeredMesh& mesh, const std::vector<double>& h,
                                const SeamChain& chain);

/// What stands at the ends of a join, first and last, relative to its length; 0 where an end is not
/// seen.
///
/// A pit is as deep as water would stand on the surface that is seen from the front, whatever parts
/// that belongs to, within a quarter of the join's length around the end, if it ran off half of the
/// length away and at silhouettes. A bump is a pit of -h. So a fork counts as well, where the
/// outlines of other parts meet beside the end: such are 0 where the join's two parts are alone.
struct JoinEnds {
  std::vector<double> pits;
  std::vector<double> bumps;
};

JoinEnds join_ends(const relief::LayeredMesh& mesh, const std::vector<double>& h,
                   const SeamChain& chain);

/// The two parts of the join of `mesh` on which the chain lies, in the scene that it was made of,
/// with what the scene says of these two.
Scene join_alone(const Scene& scene, const relief::LayeredMesh& mesh, const SeamChain& chain);

/// The ends of the same join, in the same order, in a relief of `join_alone` with edges of the same
/// length; empty where those two parts make none.
JoinEnds join_ends_alone(const Scene& scene, const relief::LayeredMesh& mesh,
                         const SeamChain& chain, relief::ReliefOptions options);

}  // namespace relievo::testing
