#include "relief/layers/layer_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "kernel/geometry/polygon.h"
#include "relief/layers/boundaries.h"
#include "relief/layers/collect_constraints.h"
#include "relief/layers/connect_sheets.h"
#include "relief/layers/crease_lines.h"
#include "relief/layers/local_order.h"
#include "relief/layers/mesh_spacing.h"
#include "relief/layers/sample_outlines.h"

namespace relievo::relief {
namespace {

/// Distance below which two vertices are one, of the detail.
constexpr double smallest_gap = 1e-3;

/// Lower bound of that distance, of the largest coordinate: well above the rounding of coordinates.
constexpr double coordinate_grain = 1e-10;

/// A connected piece of a part is dropped if it has less area than a square of this side, of the
/// detail.
constexpr double speck_side = 0.03;

/// Distance below which two vertices are one, px.
double grain_of(const Scene& scene, double detail) {
  double farthest = 0;
  for (const Part& part : scene.parts)
    for (const Ring& ring : part.outline)
      for (const Point2 p : ring) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  return std::max(smallest_gap * detail, coordinate_grain * farthest);
}

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

/// Drops the points that no edge uses and renumbers the loops, lines and images.
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

/// Finds a run of samples in the spliced loop: among the occurrences of its ends, the pair whose
/// distance along the loop is closest to the length of the run.
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

/// Finds runs of samples in the spliced loops. O(runs * length of their loops).
std::vector<LoopRun> locate_runs(const SplicedCurves& spliced, const std::vector<CurveRun>& runs) {
  std::vector<LoopRun> located;
  for (const CurveRun& run : runs) located.push_back(locate_run(spliced, run));
  return located;
}

/// Covers the base triangulation in `mesh` with the sheets of all parts and joins them.
Result<JoinedSheets> join_on(const Scene& scene, const SampledOutlines& sampled,
                             const SplicedCurves& spliced, SheetMesh mesh,
                             const RunContext& context) {
  const MarkedOutlines& marked = sampled.marked;
  mesh.loops = spliced.loops;
  for (const MarkedRing& ring : marked.rings) mesh.loop_part.push_back(ring.part);
  cover_triangles(mesh);
  const double speck = speck_side * marked.detail;
  drop_specks(speck * speck, mesh);
  make_nodes(mesh);
  if (context.cancelled()) return interrupted_error();
  const auto warnings = connect_sheets(scene, locate_runs(spliced, marked.joins), mesh);
  if (!warnings) return warnings.error();
  JoinedSheets joined;
  joined.copies = split_fans(mesh);
  joined.robin = locate_runs(spliced, marked.robin);
  joined.relation_ranges = locate_runs(spliced, marked.relation_ranges);
  joined.creases = find_creases(mesh, spliced.lines, sampled.crease_cue, scene);
  joined.warnings = marked.warnings;
  joined.warnings.insert(joined.warnings.end(), warnings->begin(), warnings->end());
  joined.mesh = std::move(mesh);
  return joined;
}

/// Numbers the elements that are used (flag not 0) in order; the others get -1.
std::vector<int> numbers(const std::vector<uint8_t>& used) {
  std::vector<int> number(used.size(), -1);
  int count = 0;
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i] != 0) number[i] = count++;
  return number;
}

/// Copies the covered triangles and the vertices that they use. Returns the number of each vertex.
std::vector<int> copy_triangles(const SheetMesh& mesh, LayeredMesh& out) {
  std::vector<uint8_t> covered(mesh.base.triangles.size());
  std::vector<uint8_t> used(mesh.points.size(), 0);
  for (size_t t = 0; t < covered.size(); ++t) {
    covered[t] = mesh.stack_begin[t + 1] > mesh.stack_begin[t] ? 1 : 0;
    if (covered[t] != 0)
      for (const int v : mesh.base.triangles[t]) used[v] = 1;
  }
  const std::vector<int> triangle = numbers(covered);
  std::vector<int> vertex = numbers(used);
  for (size_t v = 0; v < vertex.size(); ++v)
    if (vertex[v] >= 0) out.vertices.push_back(mesh.points[v]);
  for (size_t t = 0; t < triangle.size(); ++t) {
    if (triangle[t] < 0) continue;
    const auto& [a, b, c] = mesh.base.triangles[t];
    out.triangles.push_back({vertex[a], vertex[b], vertex[c]});
    std::array<int, 3> across = mesh.base.neighbours[t];
    for (int& next : across) next = next < 0 ? -1 : triangle[next];
    out.neighbours.push_back(across);
  }
  return vertex;
}

/// Copies the nodes that faces use. Returns the number of each node.
std::vector<int> copy_nodes(const SheetMesh& mesh, const Boundaries& boundaries,
                            const std::vector<int>& vertex, LayeredMesh& out) {
  std::vector<int> part(mesh.node_vertex.size(), -1);  // the frontmost that uses each node
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    for (const int n : mesh.faces[f]) part[n] = std::max(part[n], mesh.face_part[f]);
  std::vector<int> node(part.size(), -1);
  for (size_t n = 0; n < node.size(); ++n) {
    if (part[n] < 0) continue;
    node[n] = static_cast<int>(out.node_vertex.size());
    out.node_vertex.push_back(vertex[mesh.node_vertex[n]]);
    out.node_part.push_back(part[n]);
    out.node_role.push_back(boundaries.role[n]);
  }
  return node;
}

/// Copies the stacks; `node` is the number of each node.
void copy_faces(const SheetMesh& mesh, const LocalOrder& order, const std::vector<Flap>& flaps,
                const std::vector<int>& node, LayeredMesh& out) {
  int triangle = -1;
  for (int i = 0; i < static_cast<int>(mesh.faces.size()); ++i) {
    if (i == 0 || mesh.face_triangle[i] != mesh.face_triangle[i - 1]) {
      out.stack_begin.push_back(i);
      ++triangle;
    }
    const int f = order.is_usual() ? i : order.faces[i];
    const auto& [a, b, c] = mesh.faces[f];
    out.faces.push_back({node[a], node[b], node[c]});
    out.face_part.push_back(mesh.face_part[f]);
    out.face_source.push_back(mesh.face_source[f]);
    out.face_triangle.push_back(triangle);
    out.face_flap.push_back(flaps[f]);
  }
  out.stack_begin.push_back(static_cast<int>(mesh.faces.size()));
}

/// Makes the layered mesh of the joined sheets: renumbers everything without uncovered triangles,
/// unused vertices and unused nodes, orders each stack, and keeps the pairs of visible nodes.
/// `flaps` is per face of `mesh`.
LayeredMesh compact_layers(const SheetMesh& mesh, const Boundaries& boundaries,
                           const LocalOrder& order, const std::vector<Flap>& flaps,
                           const std::vector<DepthPair>& pairs) {
  LayeredMesh out;
  const std::vector<int> vertex = copy_triangles(mesh, out);
  const std::vector<int> node = copy_nodes(mesh, boundaries, vertex, out);
  copy_faces(mesh, order, flaps, node, out);
  if (boundaries.bump_nodes.empty()) out.face_source.clear();
  out.ramps = boundaries.ramps;
  for (RampNode ramp : boundaries.ramp_nodes) {
    ramp.node = node[ramp.node];
    if (ramp.below >= 0) ramp.below = node[ramp.below];
    if (ramp.node >= 0) out.ramp_nodes.push_back(ramp);
  }
  for (BumpNode bump : boundaries.bump_nodes) {
    bump.node = node[bump.node];
    if (bump.node >= 0) out.bump_nodes.push_back(bump);
  }
  const std::vector<uint8_t> seen = seen_nodes(out);
  for (DepthPair pair : pairs) {
    pair.lower = node[pair.lower];
    pair.upper = node[pair.upper];
    if (pair.lower >= 0 && pair.upper >= 0 && seen[pair.lower] != 0 && seen[pair.upper] != 0)
      out.constraints.push_back(pair);
  }
  return out;
}

Error nothing_left(double spacing) {
  return {ErrorCode::bad_input,
          "nothing is left of any part at this resolution; use more vertices (edge " +
              std::to_string(spacing) + " px)",
          "parts"};
}

/// Warns of parts of which nothing is left.
void warn_of_vanished_parts(const Scene& scene, LayeredMesh& mesh) {
  std::vector<bool> covered(scene.parts.size(), false);
  for (const int part : mesh.face_part) covered[part] = true;
  for (size_t p = 0; p < covered.size(); ++p)
    if (!covered[p])
      mesh.warnings.push_back("parts[" + std::to_string(p) + "] (\"" + scene.parts[p].id +
                              "\"): vanishes at this resolution; make it larger or use more "
                              "vertices (edge " +
                              std::to_string(mesh.edge_length) + " px)");
}

}  // namespace

Result<JoinedSheets> join_sheets(const Scene& scene, const LayerOptions& options,
                                 const RunContext& context) {
  const auto spacing = mesh_spacing(scene, options, context);
  if (!spacing) return spacing.error();
  context.report("mesh", 0.1);
  const auto sampled = sample_outlines(scene, *spacing);
  if (!sampled) return sampled.error();
  auto spliced =
      splice_curves(sampled->curves, sampled->creases, grain_of(scene, sampled->marked.detail));
  if (!spliced) return spliced.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.3);
  drop_unused_points(*spliced);
  const std::vector<std::array<int, 2>> edges = edges_of(*spliced);
  if (edges.empty()) return nothing_left(*spacing);
  SheetMesh mesh;
  mesh.points = spliced->points;
  const std::vector<Point2> inner =
      inner_points(size_field_for(*sampled, *spacing), mesh.points, edges);
  mesh.points.insert(mesh.points.end(), inner.begin(), inner.end());
  if (context.cancelled()) return interrupted_error();
  auto base = triangulate(mesh.points, edges, context);
  if (!base) return base.error();
  mesh.base = std::move(*base);
  context.report("mesh", 0.7);
  auto joined = join_on(scene, *sampled, *spliced, std::move(mesh), context);
  if (joined) joined->edge_length = *spacing;
  return joined;
}

Result<LayeredMesh> constrain_sheets(const JoinedSheets& joined, const Scene& scene,
                                     const LayerOptions& options) {
  const SheetMesh& mesh = joined.mesh;
  Boundaries boundaries = find_boundaries(mesh, scene, joined.robin, options.attach);
  if (!options.glue) boundaries.glued.clear();
  const std::vector<PlacedRelation> relations =
      place_relations(scene, joined.relation_ranges, mesh);
  const auto order = find_local_order(mesh, scene, relations);
  if (!order) return order.error();
  const std::vector<Flap> flaps = find_flaps(mesh, boundaries.role, *order, scene, options.attach);
  std::vector<DepthPair> pairs = joined.copies;
  const std::vector<DepthPair> ordered = collect_constraints(mesh, boundaries, relations, *order);
  pairs.insert(pairs.end(), ordered.begin(), ordered.end());
  LayeredMesh layers = compact_layers(mesh, boundaries, *order, flaps, pairs);
  const std::vector<DepthPair> resting = resting_pairs(layers, scene);
  layers.constraints.insert(layers.constraints.end(), resting.begin(), resting.end());
  if (layers.faces.empty()) return nothing_left(joined.edge_length);
  layers.edge_length = joined.edge_length;
  layers.creases = joined.creases;
  layers.warnings = joined.warnings;
  warn_of_vanished_parts(scene, layers);
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
