#include "relief/layers/layer_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "relief/layers/collect_constraints.h"
#include "relief/layers/compact_layers.h"
#include "relief/layers/connect_sheets.h"
#include "relief/layers/crease_lines.h"
#include "relief/layers/flaps.h"
#include "relief/layers/mesh_spacing.h"

namespace relievo::relief {
namespace {

constexpr double smallest_gap = 1e-3;       // of the detail
constexpr double coordinate_grain = 1e-10;  // of the largest coordinate
constexpr double speck_side = 0.03;  // of the detail: what has less area than its square goes

std::vector<std::array<int, 2>> edges_of(const SplicedCurves& spliced) {
  std::vector<std::array<int, 2>> edges;
  const auto add = [&edges](int a, int b) { edges.push_back({std::min(a, b), std::max(a, b)}); };
  for (const std::vector<int>& loop : spliced.loops)
    for (size_t i = 0; i < loop.size(); ++i) add(loop[i], loop[(i + 1) % loop.size()]);
  for (const std::vector<int>& line : spliced.lines)
    for (size_t i = 0; i + 1 < line.size(); ++i) add(line[i], line[i + 1]);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Keeps only the points that edges use, and renumbers the loops, lines and images.
void drop_unused_points(SplicedCurves& spliced) {
  std::vector<int> number(spliced.points.size(), -1);
  std::vector<Point2> points;
  for (std::vector<std::vector<int>>* curves : {&spliced.loops, &spliced.lines})
    for (std::vector<int>& curve : *curves)
      for (int& p : curve) {
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

/// Where a run of samples lies in the spliced loop: among the occurrences of its ends, the pair
/// whose length fits best.
LoopRun locate_run(const SplicedCurves& spliced, const CurveRun& run) {
  if (run.curve < 0) return {};
  const std::vector<int>& loop = spliced.loops[run.curve];
  const int first = spliced.image[run.curve][run.first];
  const int last = spliced.image[run.curve][run.last];
  const int n = static_cast<int>(loop.size());
  LoopRun best;
  double best_gap = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i) {
    if (loop[i] != first) continue;
    double length = 0;
    for (int edges = 1; edges < n; ++edges) {
      length += distance(spliced.points[loop[(i + edges - 1) % n]],
                         spliced.points[loop[(i + edges) % n]]);
      if (loop[(i + edges) % n] != last) continue;
      const double gap = std::abs(length - run.length);
      if (gap < best_gap) {
        best_gap = gap;
        best = {run.curve, i, edges, run.reversed};
      }
    }
  }
  return best;
}

/// Where runs of outline samples lie in the spliced loops; loop -1 where a run has collapsed.
/// O(runs * length of their loops).
std::vector<LoopRun> locate_runs(const SplicedCurves& spliced, const std::vector<CurveRun>& runs) {
  std::vector<LoopRun> located;
  for (const CurveRun& run : runs) located.push_back(locate_run(spliced, run));
  return located;
}

/// The joins of the scene as paths of base vertices. Fails with bad_input naming the join.
Result<std::vector<JoinPath>> join_paths(const Scene& scene, const SplicedCurves& spliced,
                                         const std::vector<LoopRun>& runs) {
  std::vector<JoinPath> paths;
  for (size_t j = 0; j < scene.joins.size(); ++j) {
    const Join& join = scene.joins[j];
    JoinPath path;
    path.upper = join.upper;
    path.lower = join.lower;
    path.culprit = {CulpritList::joins, j};
    path.name = to_string(path.culprit) + " (\"" + scene.parts[join.upper].id + "\" to \"" +
                scene.parts[join.lower].id + "\")";
    if (runs[j].loop < 0)
      return Error{ErrorCode::bad_input, "the outline collapses along the join; use a finer mesh",
                   path.name, path.culprit};
    path.loop = runs[j].loop;
    path.position = runs[j].position;
    const std::vector<int>& loop = spliced.loops[path.loop];
    for (int i = 0; i <= runs[j].edges; ++i)
      path.vertices.push_back(loop[(path.position + i) % loop.size()]);
    paths.push_back(std::move(path));
  }
  return paths;
}

/// What all parts will lie on.
struct Triangulation {
  std::vector<Point2> points;
  PlanarTriangulation mesh;
};

/// The parts on a triangulation, joined.
Result<JoinedSheets> join_on(const Scene& scene, const SampledOutlines& sampled,
                             const SplicedCurves& spliced, Triangulation triangulation,
                             const RunContext& context) {
  Loops loops{spliced.loops, sampled.curve_part};
  Cover cover = cover_triangles(triangulation.mesh, loops.vertices, loops.part);
  const double speck = speck_side * sampled.detail;
  drop_specks(triangulation.mesh, triangulation.points, speck * speck, cover);
  JoinedSheets joined;
  SheetMesh& mesh = joined.mesh;
  mesh = make_sheets(std::move(triangulation.points), std::move(triangulation.mesh),
                     std::move(loops), cover);
  if (context.cancelled()) return interrupted_error();
  const auto paths = join_paths(scene, spliced, locate_runs(spliced, sampled.joins));
  if (!paths) return paths.error();
  const auto warnings = connect_sheets(*paths, static_cast<int>(scene.parts.size()), mesh);
  if (!warnings) return warnings.error();
  joined.copies = split_fans(mesh);
  mesh.node_part = frontmost_parts(mesh);
  joined.robin = locate_runs(spliced, sampled.robin);
  const std::vector<LoopRun> ranges = locate_runs(spliced, sampled.relation_ranges);
  for (size_t r = 0; r < ranges.size(); ++r)
    if (scene.relations[r].range) joined.relation_ranges.push_back(ranges[r]);
  joined.creases = find_creases(mesh, spliced.lines, sampled.crease_cue, scene);
  joined.warnings = sampled.warnings;
  joined.warnings.insert(joined.warnings.end(), warnings->begin(), warnings->end());
  return joined;
}

Error nothing_left(double spacing) {
  return {ErrorCode::bad_input,
          "nothing is left of any part at this resolution; use more vertices (edge " +
              std::to_string(spacing) + " px)",
          "parts"};
}

/// What is to be said of parts of which nothing is left.
std::vector<std::string> vanished_parts(const LayeredMesh& mesh, const Scene& scene) {
  std::vector<bool> covered(scene.parts.size(), false);
  for (const int part : mesh.face_part) covered[part] = true;
  std::vector<std::string> warnings;
  for (size_t p = 0; p < covered.size(); ++p)
    if (!covered[p])
      warnings.push_back("parts[" + std::to_string(p) + "] (\"" + scene.parts[p].id +
                         "\"): vanishes at this resolution; make it larger or use more vertices "
                         "(edge " +
                         std::to_string(mesh.edge_length) + " px)");
  return warnings;
}

/// Distance below which two vertices are one: a small fraction of the detail, and much more than
/// rounding of the coordinates.
double grain_of(const Scene& scene, double detail) {
  double farthest = 0;
  for (const Part& part : scene.parts)
    for (const Ring& ring : part.outline)
      for (const Point2 p : ring) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  return std::max(smallest_gap * detail, coordinate_grain * farthest);
}

/// One per relation of the scene; loop -1 where it has no range.
std::vector<LoopRun> runs_of_relations(const JoinedSheets& joined, const Scene& scene) {
  std::vector<LoopRun> runs;
  auto next = joined.relation_ranges.begin();
  for (const Relation& relation : scene.relations)
    runs.push_back(relation.range ? *next++ : LoopRun{});
  return runs;
}

}  // namespace

Result<JoinedSheets> join_sheets(const Scene& scene, const LayerOptions& options,
                                 const RunContext& context) {
  const auto spacing = mesh_spacing(scene, options, context);
  if (!spacing) return spacing.error();
  context.report("mesh", 0.1);
  const auto sampled = sample_outlines(scene, *spacing);
  if (!sampled) return sampled.error();
  auto spliced = splice_curves(sampled->curves, sampled->creases, grain_of(scene, sampled->detail));
  if (!spliced) return spliced.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.3);
  drop_unused_points(*spliced);
  const std::vector<std::array<int, 2>> edges = edges_of(*spliced);
  if (edges.empty()) return nothing_left(*spacing);
  std::vector<Point2> points = spliced->points;
  const SizeField field = size_field_for(*sampled, *spacing, options);
  const std::vector<Point2> inner = inner_points(field, points, edges);
  points.insert(points.end(), inner.begin(), inner.end());
  if (context.cancelled()) return interrupted_error();
  auto mesh = triangulate(points, edges, context);
  if (!mesh) return mesh.error();
  context.report("mesh", 0.7);
  auto joined = join_on(scene, *sampled, *spliced, {std::move(points), std::move(*mesh)}, context);
  if (joined) joined->edge_length = *spacing;
  return joined;
}

Result<LayeredMesh> constrain_sheets(const JoinedSheets& joined, const Scene& scene,
                                     const LayerOptions& options) {
  const SheetMesh& mesh = joined.mesh;
  Boundaries boundaries = find_boundaries(mesh, scene, joined.robin, options.attach);
  if (!options.glue) boundaries.glued.clear();
  const std::vector<LoopRun> ranges = runs_of_relations(joined, scene);
  const auto order = find_local_order(mesh, scene, ranges);
  if (!order) return order.error();
  const std::vector<Flap> flaps = find_flaps(mesh, boundaries, *order, scene, options.attach);
  std::vector<DepthPair> pairs = joined.copies;
  const std::vector<DepthPair> ordered =
      collect_constraints(mesh, boundaries, scene, ranges, *order);
  pairs.insert(pairs.end(), ordered.begin(), ordered.end());
  LayeredMesh layers = compact_layers(mesh, boundaries, {*order, flaps}, pairs);
  const std::vector<DepthPair> resting = resting_pairs(layers, scene);
  layers.constraints.insert(layers.constraints.end(), resting.begin(), resting.end());
  if (layers.faces.empty()) return nothing_left(joined.edge_length);
  layers.edge_length = joined.edge_length;
  layers.creases = joined.creases;
  layers.warnings = joined.warnings;
  const std::vector<std::string> vanished = vanished_parts(layers, scene);
  layers.warnings.insert(layers.warnings.end(), vanished.begin(), vanished.end());
  layers.part_count = static_cast<int>(scene.parts.size());
  return layers;
}

Result<LayeredMesh> layer_parts(const Scene& scene, const LayerOptions& options,
                                const RunContext& context) {
  const auto joined = join_sheets(scene, options, context);
  if (!joined) return joined.error();
  return constrain_sheets(*joined, scene, options);
}

}  // namespace relievo::relief
