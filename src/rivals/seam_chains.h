#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo {

/// A join as it lies on the mesh: a chain of nodes on which the faces of the upper part and of
/// those below it meet.
struct SeamChain {
  int upper = -1;
  std::vector<int> nodes;      ///< from end to end
  std::vector<double> length;  ///< along the chain up to each node, px
};

/// The nodes of bumps' outlines that are not on joins.
std::set<int> loose_rims(const LayeredMesh& mesh);

/// All joins, in the order of their upper parts. Near-linear.
std::vector<SeamChain> seam_chains(const LayeredMesh& mesh);

/// What becomes of the run of the upper outline along which a join was.
enum class Roots {
  closed,  ///< as all of the outline: u = 0, above the lower part
  open,    ///< natural boundary but for its ends, at the height of the lower part
};

/// A joined mesh with every part on nodes of its own again: same triangles, same stacks.
struct SeparateParts {
  LayeredMesh mesh;
  std::vector<int> joined_node;    ///< #N of `mesh`: the node of the joined mesh that it was, the
                                   ///< frontmost where there were several
  std::vector<int> separate_node;  ///< #N of the joined mesh: the node of its frontmost part
};

/// Takes joins and bumps apart. Depth pairs of the joined mesh hold between the same parts as
/// before, those of joins are added. Without creases, ramps and flaps. Near-linear.
SeparateParts separate_parts(const LayeredMesh& joined, Roots roots);

/// A surface whose heights were changed where it was grafted.
struct Graft {
  std::vector<double> h;  ///< #N, px
  double residual = 0;    ///< most |(L M^-1 L h)_n| over grafted nodes / the scale of its terms
};

/// Nodes no farther along the joined surface from a join than `width` times its length: straight
/// distances to the nearest of its nodes, reached over edges; but for what is beside the rest of a
/// bump's outline. #N flags. O(edges log N).
std::vector<uint8_t> band_around_joins(const LayeredMesh& mesh, double width);

/// Replaces the heights of `grafted` nodes by the solution of L M^-1 L h = 0 with all other nodes,
/// and those on outlines, held: the least bending of what is inside the surface, which continues
/// the heights and slopes around it. Sýkora et al. 2014, section on grafting; the discretisation is
/// our reading. Fails with internal where the system is singular, or interrupted.
Result<Graft> graft(const LayeredMesh& mesh, const Discretisation& discretisation,
                    const std::vector<double>& h, const std::vector<uint8_t>& grafted,
                    const RunContext& context = {});

}  // namespace relievo
