#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The depth pairs of all overlapping parts by the default table and the scene's relations:
///   upper outline beside a join, in the Robin range            equal ("glued")
///   loop of an unjoined part wholly inside lower parts         equal with the nearest below
///   other upper outlines inside a lower part                   not below it
///   lower outline or flap edge under an upper part             not above it
///   vertices on two outlines                                   nothing
/// Where `order` has two parts the other way round, so are "above" and "below" between them; where
/// it has them both ways around a vertex there is nothing but what relations say of that place.
/// At each base vertex the pairs form a forest. `node_part` as in LayeredMesh. Near-linear.
std::vector<DepthPair> collect_constraints(const SheetMesh& mesh, const Boundaries& boundaries,
                                           const Scene& scene,
                                           const std::vector<LoopRun>& relation_runs,
                                           const LocalOrder& order);

/// Pairs of nodes inside two parts of which the front one is seen and may rest on the other, the
/// next below out of which it does not grow: a flat patch on a round belly. None where the front
/// part has d < 0 or a relation "free" without a range lets it pass. Sorted, each once. O(F log F).
std::vector<DepthPair> resting_pairs(const LayeredMesh& mesh, const Scene& scene);

}  // namespace relievo::relief
