#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/layers/boundaries.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

struct LayerOptions {
  /// Wanted number of nodes of the joined mesh; the result is within a few per cent of it.
  /// Used where edge_length is 0.
  int vertex_budget = 40000;
  /// Spacing of outline samples, px; 0: chosen from vertex_budget.
  double edge_length = 0;
  /// How much longer an edge may get per unit of distance from the nearest outline.
  double grading = 0.25;
  /// Longest edge / edge_length.
  double max_growth = 8;
  /// Upper outlines beside a join follow the lower surface exactly ("glued"); otherwise they
  /// may rise above it.
  bool glue = true;
  /// Outlines beside a join begin at the height of the lower surface, and what lies hidden under
  /// a part that grows out of it shapes nothing; otherwise such outlines are only pulled to the
  /// drawing plane less there, as in the paper.
  bool attach = true;
  /// More nodes than this are refused before they are made.
  int max_nodes = 4000000;
};

/// All parts on one triangulation, joined: what the outlines and joins decide.
struct JoinedSheets {
  SheetMesh mesh;
  std::vector<LoopRun> robin;            ///< per Robin range of the scene
  std::vector<LoopRun> relation_ranges;  ///< per relation with a range
  std::vector<DepthPair> copies;         ///< nodes that were split to keep the mesh manifold
  std::vector<CreaseEdge> creases;
  double edge_length = 0;  ///< spacing of the outlines, px
  std::vector<std::string> warnings;
};

/// Puts all parts on one triangulation and joins them. Of the scene it reads the outlines, the
/// order and ids of the parts, the joins, the ends of Robin and relation ranges, and the lines of
/// creases; of the options all but `glue` and `attach`. Fails with bad_input or contradiction
/// naming the part or join, limit, or interrupted. Near-linear in the number of nodes.
Result<JoinedSheets> join_sheets(const Scene& scene, const LayerOptions& options,
                                 const RunContext& context = {});

/// Finds boundaries and constraint sets on the joined sheets of the scene. Fails with contradiction
/// naming relations, and with bad_input where nothing is left of any part; warnings name those of
/// which nothing is. Near-linear in the number of nodes.
Result<LayeredMesh> constrain_sheets(const JoinedSheets& joined, const Scene& scene,
                                     const LayerOptions& options);

/// Both: puts all parts on one triangulation, joins them and collects the constraint sets.
Result<LayeredMesh> layer_parts(const Scene& scene, const LayerOptions& options,
                                const RunContext& context = {});

}  // namespace relievo::relief
