#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/meshing/size_field.h"
#include "relief/layers/boundaries.h"
#include "relief/layers/layer_parts.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sample_outlines.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo {

/// The spacing of outline samples: as given, or the one at which the joined mesh has about the
/// wanted number of nodes. Fails with `limit` where the mesh would certainly exceed max_nodes.
/// Costs a few samplings of the outlines, no triangulation; fails with `interrupted` where
/// `context` is cancelled.
Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context);

/// The wanted edge length around sampled outlines.
SizeField size_field_for(const SampledOutlines& sampled, double spacing,
                         const LayerOptions& options);

/// Points between the outlines, clear of the edges by a fraction of the size there.
/// O(points + edges) for edges about as long as the size beside them.
std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges);

/// What lies under parts that grow out of it, #F: from the covered side of each join as far as the
/// upper part covers the surface, in front of it. Kept where `loose` is false,
/// where d changes its sign on that surface, and where what would be left of it has no outline. O(F
/// + faces of the flaps).
std::vector<Flap> find_flaps(const SheetMesh& mesh, const Boundaries& boundaries,
                             const LocalOrder& order, const Scene& scene, bool loose);

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

/// How the faces of the sheets come to lie.
struct FaceOrder {
  const LocalOrder& local;
  const std::vector<Flap>& flaps;  ///< #F
};

/// The finished mesh: everything renumbered without uncovered triangles, unused vertices and
/// unused nodes, faces as they lie, and with the pairs of nodes that are seen. O(T + F).
LayeredMesh compact_layers(const SheetMesh& mesh, const Boundaries& boundaries,
                           const FaceOrder& faces, const std::vector<DepthPair>& pairs);

}  // namespace relievo
