#pragma once

#include <string>
#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

struct LayerOptions {
  /// Wanted number of nodes of the joined mesh, met within a few per cent. Used if edge_length is
  /// 0.
  int vertex_budget = 40000;
  /// Spacing of outline samples, px; 0: chosen from vertex_budget.
  double edge_length = 0;
  /// Upper outlines beside a join follow the lower surface exactly ("glued"); otherwise they
  /// may rise above it.
  bool glue = true;
  /// Outlines beside a join begin at the height of the lower surface, and what is hidden behind a
  /// part that grows out of it shapes nothing. Otherwise such outlines are only pulled less towards
  /// the drawing plane there, as in the paper.
  bool attach = true;
  /// A mesh that would have more nodes is refused before it is made.
  int max_nodes = 4000000;
};

/// All parts on one triangulation, joined. Depends on the outlines and joins of a scene alone.
struct JoinedSheets {
  SheetMesh mesh;
  std::vector<LoopRun> robin;            ///< per Robin range of the scene
  std::vector<LoopRun> relation_ranges;  ///< per relation with a range
  std::vector<DepthPair> copies;         ///< nodes that were split to keep the mesh manifold
  std::vector<CreaseEdge> creases;
  double edge_length = 0;  ///< spacing of the outlines, px
  std::vector<std::string> warnings;
};

/// Puts all parts on one triangulation and joins them. Reads the outlines, order and ids of the
/// parts, the joins, the ends of Robin and relation ranges, and the lines of creases; of the
/// options all but `glue` and `attach`. Fails with bad_input or contradiction naming the part or
/// join, limit, or interrupted. Near-linear in the number of nodes.
Result<JoinedSheets> join_sheets(const Scene& scene, const LayerOptions& options,
                                 const RunContext& context = {});

/// Finds the boundary conditions and constraint sets of the joined sheets of a scene. Warnings name
/// parts of which nothing is left. Fails with contradiction naming relations, and with bad_input if
/// nothing is left of any part. Near-linear in the number of nodes.
Result<LayeredMesh> constrain_sheets(const JoinedSheets& joined, const Scene& scene,
                                     const LayerOptions& options);

/// Calls join_sheets, then constrain_sheets.
Result<LayeredMesh> layer_parts(const Scene& scene, const LayerOptions& options,
                                const RunContext& context = {});

}  // namespace relievo::relief
