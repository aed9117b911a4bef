#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/local_order.h"

namespace relievo {

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

}  // namespace relievo
