#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"

namespace relievo::relief {

/// How the faces of the sheets come to lie.
struct FaceOrder {
  const LocalOrder& local;
  const std::vector<Flap>& flaps;  ///< #F
};

/// The finished mesh: everything renumbered without uncovered triangles, unused vertices and
/// unused nodes, faces as they lie, and with the pairs of nodes that are seen. O(T + F).
LayeredMesh compact_layers(const SheetMesh& mesh, const Boundaries& boundaries,
                           const FaceOrder& faces, const std::vector<DepthPair>& pairs);

}  // namespace relievo::relief
