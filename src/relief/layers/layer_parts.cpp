#include "relief/layers/layer_parts.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "relief/layers/collect_constraints.h"
#include "relief/layers/compact_layers.h"
#include "relief/layers/inner_points.h"
#include "relief/layers/loop_runs.h"
#include "relief/layers/mesh_spacing.h"

namespace relievo {
namespace {

std::vector<std::array<int, 2>> edges_of(const std::vector<std::vector<int>>& loops) {
  std::vector<std::array<int, 2>> edges;
  for (const std::vector<int>& loop : loops)
    for (size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i];
      const int b = loop[(i + 1) % loop.size()];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Keeps only the points that edges use, and renumbers the loops and images.
void drop_unused_points(SplicedCurves& spliced) {
  std::vector<int> number(spliced.points.size(), -1);
  std::vector<Point2> points;
  for (std::vector<int>& loop : spliced.loops)
    for (int& p : loop) {
      if (number[p] < 0) {
        number[p] = static_cast<int>(points.size());
        points.push_back(spliced.points[p]);
      }
      p = number[p];
    }
  for (std::vector<int>& image : spliced.image)
    for (int& p : image) p = number[p];
  spliced.points = std::move(points);
}

Result<LayeredMesh> join_layers(const Scene& scene, const SampledOutlines& sampled,
                                const SplicedCurves& spliced, const BaseMesh& base,
                                const LayerOptions& options) {
  const Loops loops{spliced.loops, sampled.curve_part};
  const Cover cover = cover_triangles(base.mesh, loops.vertices, loops.part);
  Sheets sheets = make_sheets(base, cover);
  const auto paths = join_paths(scene, spliced, locate_runs(spliced, sampled.joins));
  if (!paths) return paths.error();
  const auto connection =
      connect_sheets(base, *paths, static_cast<int>(scene.parts.size()), sheets);
  if (!connection) return connection.error();
  std::vector<DepthPair> pairs = split_fans(base, sheets);
  sheets.node_part = frontmost_parts(sheets);
  const Boundaries boundaries =
      find_boundaries(base, sheets, loops, *connection, scene, locate_runs(spliced, sampled.robin));
  const std::vector<DepthPair> ordered =
      collect_constraints(base, sheets, loops, *connection, boundaries, scene,
                          locate_runs(spliced, sampled.relation_ranges), options.glue);
  pairs.insert(pairs.end(), ordered.begin(), ordered.end());
  LayeredMesh mesh = compact_layers(base, sheets, boundaries, pairs);
  mesh.warnings = sampled.warnings;
  mesh.warnings.insert(mesh.warnings.end(), connection->warnings.begin(),
                       connection->warnings.end());
  return mesh;
}

Status check_covered(const LayeredMesh& mesh, const Scene& scene, double spacing) {
  std::vector<bool> covered(scene.parts.size(), false);
  for (const int part : mesh.face_part) covered[part] = true;
  for (size_t p = 0; p < covered.size(); ++p)
    if (!covered[p])
      return Error{
          ErrorCode::bad_input,
          "the part \"" + scene.parts[p].id +
              "\" vanishes at this resolution; make it larger or use more vertices (edge " +
              std::to_string(spacing) + " px)",
          "parts[" + std::to_string(p) + "]"};
  return Done{};
}

}  // namespace

Result<LayeredMesh> layer_parts(const Scene& scene, const LayerOptions& options,
                                const RunContext& context) {
  const auto spacing = mesh_spacing(scene, options);
  if (!spacing) return spacing.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.1);
  const auto sampled = sample_outlines(scene, *spacing);
  if (!sampled) return sampled.error();
  auto spliced = splice_curves(sampled->curves);
  if (!spliced) return spliced.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.3);
  drop_unused_points(*spliced);
  const std::vector<std::array<int, 2>> edges = edges_of(spliced->loops);
  std::vector<Point2> points = spliced->points;
  const SizeField field = size_field_for(*sampled, *spacing, options);
  const std::vector<Point2> inner = inner_points(field, points, edges);
  points.insert(points.end(), inner.begin(), inner.end());
  auto mesh = triangulate(points, edges);
  if (!mesh) return mesh.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.7);
  const BaseMesh base = make_base_mesh(std::move(points), std::move(*mesh));
  auto layers = join_layers(scene, *sampled, *spliced, base, options);
  if (!layers) return layers.error();
  if (Status status = check_covered(*layers, scene, *spacing); !status) return status.error();
  layers->part_count = static_cast<int>(scene.parts.size());
  layers->edge_length = *spacing;
  return layers;
}

}  // namespace relievo
