#include "relief/layers/layer_parts.h"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/ring_measure.h"
#include "kernel/meshing/segment_grid.h"
#include "relief/layers/collect_constraints.h"

namespace relievo {
namespace {

constexpr double kClearance = 0.62;  // of the wanted size, between inner points and outlines

/// Inner points that keep clear of the edges.
std::vector<Point2> clear_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges) {
  Box2 box;
  for (const Point2 p : points) box.add(p);
  SegmentGrid grid(box, edges.size());
  grid.build(edges.size(),
             [&](size_t e) { return std::pair(points[edges[e][0]], points[edges[e][1]]); });
  std::vector<Point2> kept;
  for (const Point2 p : lattice_points(field)) {
    const double clearance = kClearance * field.size_at(p);
    bool clear = true;
    grid.for_cells(p, p, clearance, [&](size_t cell) {
      for (const int* e = grid.begin(cell); clear && e != grid.end(cell); ++e)
        clear = distance_to_segment(p, points[edges[*e][0]], points[edges[*e][1]]) >= clearance;
    });
    if (clear) kept.push_back(p);
  }
  return kept;
}

std::vector<Outline> outlines_of(const SampledOutlines& sampled) {
  std::vector<Outline> outlines;
  for (size_t c = 0; c < sampled.curves.size(); ++c) {
    if (sampled.curve_part[c] >= static_cast<int>(outlines.size()))
      outlines.resize(sampled.curve_part[c] + 1);
    outlines[sampled.curve_part[c]].push_back(sampled.curves[c].points);
  }
  return outlines;
}

SizeField size_field_for(const SampledOutlines& sampled, double spacing,
                         const LayerOptions& options) {
  Box2 box;
  for (const CurveSample& sample : sampled.samples) box.add(sample.position);
  SizeOptions size;
  size.grading = options.grading;
  size.max_size = spacing * options.max_growth;
  const double longest = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  size.cells = std::clamp(static_cast<int>(longest / (2 * spacing)), 64, 2048);
  return make_size_field(sampled.samples, outlines_of(sampled), size);
}

/// How many nodes a spacing would give, without triangulating.
struct NodeEstimate {
  double along = 0;   // on outlines, grows like 1 / spacing
  double inside = 0;  // between them, grows like 1 / spacing^2
};

/// Sheets at an outline sample: its own and those of the other parts there, probed on both sides.
double nodes_at_outline(const SizeField& field, Point2 a, Point2 b) {
  const double length = std::max(distance(a, b), 1e-300);
  const Point2 aside = (1.5 * field.cell / length) * Point2{a.y - b.y, b.x - a.x};
  return 0.5 * (field.cover_at(a + aside) + field.cover_at(a - aside)) + 0.5;
}

Result<NodeEstimate> estimate_nodes(const Scene& scene, double spacing,
                                    const LayerOptions& options) {
  const auto sampled = sample_outlines(scene, spacing);
  if (!sampled) return sampled.error();
  const SizeField field = size_field_for(*sampled, spacing, options);
  NodeEstimate estimate;
  std::vector<Point2> points;
  std::vector<std::array<int, 2>> edges;
  for (const InputCurve& curve : sampled->curves) {
    const int first = static_cast<int>(points.size());
    const int n = static_cast<int>(curve.points.size());
    for (int i = 0; i < n; ++i) {
      points.push_back(curve.points[i]);
      edges.push_back({first + i, first + (i + 1) % n});
      estimate.along += nodes_at_outline(field, curve.points[i], curve.points[(i + 1) % n]);
    }
  }
  for (const Point2 p : clear_points(field, points, edges)) estimate.inside += field.cover_at(p);
  return estimate;
}

/// Summed perimeters and areas of all rings.
struct Extent {
  double length = 0;
  double area = 0;
};

Extent measure_outlines(const Scene& scene) {
  Extent extent;
  for (const Part& part : scene.parts)
    for (const Ring& ring : part.outline) {
      extent.length += perimeter(ring);
      extent.area += std::abs(signed_area(ring));
    }
  return extent;
}

/// Refuses spacings that would certainly give more nodes than allowed, before anything is made.
Status check_size(const Scene& scene, double spacing, const LayerOptions& options) {
  const Extent extent = measure_outlines(scene);
  const double coarsest = spacing * options.max_growth;
  const double least = extent.length / spacing + extent.area / (coarsest * coarsest);
  if (least > options.max_nodes || options.vertex_budget > options.max_nodes)
    return Error{ErrorCode::limit,
                 "the mesh would have more than " + std::to_string(options.max_nodes) +
                     " vertices; use fewer vertices or longer edges",
                 ""};
  return Done{};
}

/// The spacing at which the joined mesh has about the wanted number of nodes.
Result<double> choose_spacing(const Scene& scene, const LayerOptions& options) {
  const auto [length, area] = measure_outlines(scene);
  const double budget = options.vertex_budget;
  // Twice the plain counts: sheets repeat the outlines of others, and grading thins the inside.
  double spacing = (length + std::sqrt(length * length + 0.3 * budget * area)) / budget;
  for (int round = 0; round < 5; ++round) {
    const auto estimate = estimate_nodes(scene, spacing, options);
    if (!estimate) return estimate.error();
    const double along = estimate->along;
    const double inside = estimate->inside;
    if (std::abs(along + inside - budget) < 0.01 * budget) break;
    // budget = along / x + inside / x^2 for the new spacing x * spacing
    spacing *= (along + std::sqrt(along * along + 4 * budget * inside)) / (2 * budget);
  }
  return spacing;
}

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

/// Where a run of samples lies in the spliced loop: among the occurrences of its ends, the pair
/// whose length fits best.
LoopRun locate_run(const SplicedCurves& spliced, const CurveRun& run) {
  if (run.curve < 0) return {};
  const std::vector<int>& loop = spliced.loops[run.curve];
  const int first = spliced.image[run.curve][run.first];
  const int last = spliced.image[run.curve][run.last];
  const int n = static_cast<int>(loop.size());
  LoopRun best;
  double best_gap = 1e300;
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

std::vector<LoopRun> locate_runs(const SplicedCurves& spliced, const std::vector<CurveRun>& runs) {
  std::vector<LoopRun> located;
  for (const CurveRun& run : runs) located.push_back(locate_run(spliced, run));
  return located;
}

Result<std::vector<JoinPath>> join_paths(const Scene& scene, const SplicedCurves& spliced,
                                         const std::vector<LoopRun>& runs) {
  std::vector<JoinPath> paths;
  for (size_t j = 0; j < scene.joins.size(); ++j) {
    const Join& join = scene.joins[j];
    JoinPath path;
    path.upper = join.upper;
    path.lower = join.lower;
    path.name = "joins[" + std::to_string(j) + "] (\"" + scene.parts[join.upper].id + "\" to \"" +
                scene.parts[join.lower].id + "\")";
    if (runs[j].loop < 0)
      return Error{ErrorCode::bad_input, "the outline collapses along the join; use a finer mesh",
                   path.name};
    path.loop = runs[j].loop;
    path.position = runs[j].position;
    const std::vector<int>& loop = spliced.loops[path.loop];
    for (int i = 0; i <= runs[j].edges; ++i)
      path.vertices.push_back(loop[(path.position + i) % loop.size()]);
    paths.push_back(std::move(path));
  }
  return paths;
}

std::vector<int> frontmost_parts(const Sheets& sheets) {
  std::vector<int> part(sheets.node_vertex.size(), -1);
  for (size_t f = 0; f < sheets.faces.size(); ++f)
    for (const int n : sheets.faces[f]) part[n] = std::max(part[n], sheets.face_part[f]);
  return part;
}

/// Renumbers everything without uncovered triangles, unused vertices and unused nodes.
class Compactor {
 public:
  Compactor(const BaseMesh& base, const Sheets& sheets) : base_(base), sheets_(sheets) {
    triangle_.assign(base.mesh.triangles.size(), -1);
    vertex_.assign(base.points.size(), -1);
    node_.assign(sheets.node_vertex.size(), -1);
  }

  LayeredMesh run() {
    copy_triangles();
    copy_nodes();
    return std::move(out_);
  }

  void add_roles(const Boundaries& boundaries, LayeredMesh& mesh) const {
    mesh.node_role.resize(mesh.node_vertex.size());
    for (size_t n = 0; n < node_.size(); ++n)
      if (node_[n] >= 0) mesh.node_role[node_[n]] = boundaries.role[n];
    mesh.ramps = boundaries.ramps;
    for (RampNode node : boundaries.ramp_nodes) {
      node.node = node_[node.node];
      if (node.node >= 0) mesh.ramp_nodes.push_back(node);
    }
  }

  void add_constraints(const std::vector<DepthPair>& pairs, LayeredMesh& mesh) const {
    for (DepthPair pair : pairs) {
      pair.lower = node_[pair.lower];
      pair.upper = node_[pair.upper];
      if (pair.lower >= 0 && pair.upper >= 0) mesh.constraints.push_back(pair);
    }
  }

 private:
  void copy_triangles() {
    out_.stack_begin.push_back(0);
    const auto covered = [&](int t) {
      return t >= 0 && sheets_.stack_begin[t + 1] > sheets_.stack_begin[t];
    };
    int count = 0;
    for (size_t t = 0; t < triangle_.size(); ++t)
      if (covered(static_cast<int>(t))) triangle_[t] = count++;
    for (size_t t = 0; t < triangle_.size(); ++t) {
      if (triangle_[t] < 0) continue;
      for (const int v : base_.mesh.triangles[t]) vertex_[v] = 0;
      std::array<int, 3> across{};
      for (int k = 0; k < 3; ++k) {
        const int next = base_.mesh.neighbours[t][k];
        across[k] = covered(next) ? triangle_[next] : -1;
      }
      out_.neighbours.push_back(across);
      out_.triangles.push_back(base_.mesh.triangles[t]);
      for (int f = sheets_.stack_begin[t]; f < sheets_.stack_begin[t + 1]; ++f) {
        out_.faces.push_back(sheets_.faces[f]);
        out_.face_part.push_back(sheets_.face_part[f]);
        out_.face_triangle.push_back(triangle_[t]);
      }
      out_.stack_begin.push_back(static_cast<int>(out_.faces.size()));
    }
    for (size_t v = 0; v < vertex_.size(); ++v) {
      if (vertex_[v] < 0) continue;
      vertex_[v] = static_cast<int>(out_.vertices.size());
      out_.vertices.push_back(base_.points[v]);
    }
    for (auto& triangle : out_.triangles)
      for (int& v : triangle) v = vertex_[v];
  }

  void copy_nodes() {
    const std::vector<int> part = frontmost_parts(sheets_);
    for (size_t n = 0; n < node_.size(); ++n) {
      if (part[n] < 0) continue;
      node_[n] = static_cast<int>(out_.node_vertex.size());
      out_.node_vertex.push_back(vertex_[sheets_.node_vertex[n]]);
      out_.node_part.push_back(part[n]);
    }
    for (auto& face : out_.faces)
      for (int& n : face) n = node_[n];
  }

  const BaseMesh& base_;
  const Sheets& sheets_;
  std::vector<int> triangle_;
  std::vector<int> vertex_;
  std::vector<int> node_;
  LayeredMesh out_;
};

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
  const std::vector<DepthPair> ties = split_fans(base, sheets);
  sheets.node_part = frontmost_parts(sheets);
  const Boundaries boundaries =
      find_boundaries(base, sheets, loops, *connection, scene, locate_runs(spliced, sampled.robin));
  const std::vector<DepthPair> pairs =
      collect_constraints(base, sheets, loops, *connection, boundaries, scene,
                          locate_runs(spliced, sampled.relation_ranges), options.glue);
  Compactor compactor(base, sheets);
  LayeredMesh mesh = compactor.run();
  compactor.add_roles(boundaries, mesh);
  compactor.add_constraints(ties, mesh);
  compactor.add_constraints(pairs, mesh);
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
  double spacing = options.edge_length;
  if (spacing <= 0) {
    const auto chosen = choose_spacing(scene, options);
    if (!chosen) return chosen.error();
    spacing = *chosen;
  }
  if (Status status = check_size(scene, spacing, options); !status) return status.error();
  context.report("mesh", 0.1);
  const auto sampled = sample_outlines(scene, spacing);
  if (!sampled) return sampled.error();
  auto spliced = splice_curves(sampled->curves);
  if (!spliced) return spliced.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.3);
  drop_unused_points(*spliced);
  const std::vector<std::array<int, 2>> edges = edges_of(spliced->loops);
  std::vector<Point2> points = spliced->points;
  const SizeField field = size_field_for(*sampled, spacing, options);
  const std::vector<Point2> inner = clear_points(field, points, edges);
  points.insert(points.end(), inner.begin(), inner.end());
  auto mesh = triangulate(points, edges);
  if (!mesh) return mesh.error();
  if (context.cancelled()) return interrupted_error();
  context.report("mesh", 0.7);
  const BaseMesh base = make_base_mesh(std::move(points), std::move(*mesh));
  auto layers = join_layers(scene, *sampled, *spliced, base, options);
  if (!layers) return layers.error();
  if (Status status = check_covered(*layers, scene, spacing); !status) return status.error();
  layers->part_count = static_cast<int>(scene.parts.size());
  layers->edge_length = spacing;
  return layers;
}

}  // namespace relievo
