#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Collects the depth pairs of all overlapping parts [P eq 11], by the relations of the scene or
/// else by this table:
///   upper outline beside a join, in the Robin range            equal ("glued")
///   loop of an unjoined part wholly inside lower parts         equal with the nearest below
///   other upper outlines inside a lower part                   not below it
///   lower outline or flap edge under an upper part             not above it
///   vertices on two outlines                                   nothing
/// "Above" and "below" are exchanged for two parts that `order` has swapped. At a vertex around
/// which it has them both ways only relations with a range apply. At each base vertex the pairs
/// form a forest. Near-linear.
std::vector<DepthPair> collect_constraints(const SheetMesh& mesh, const Boundaries& boundaries,
                                           const std::vector<PlacedRelation>& relations,
                                           const LocalOrder& order);

/// Lists the pairs of interior nodes at which a visible part may rest on the face directly behind
/// it that is not a flap, such as a flat patch on a round belly. A part with d < 0 rests on
/// nothing, and relations "free" without a range let parts pass. Sorted, each once. O(F log F).
std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo::relief
