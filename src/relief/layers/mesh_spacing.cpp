#include "relief/layers/mesh_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "kernel/base/workers.h"
#include "kernel/geometry/polygon.h"
#include "kernel/meshing/segment_grid.h"

namespace relievo::relief {
namespace {

/// Smallest spacing, of the longer side of the drawing. Meshes of millions of nodes stay far above
/// it; drawings of specks that are far apart would ask for less.
constexpr double finest_spacing = 1.0 / 16384;

/// Growth of the edge length per unit of distance from the nearest outline.
constexpr double grading = 0.25;

/// Longest edge, of the spacing.
constexpr double max_growth = 8;

/// Smallest distance between inner points and outlines, of the wanted size there: more than half,
/// so that no inner point lies in the circle over an outline edge.
constexpr double relative_clearance = 0.62;

/// Something that is partly along outlines and partly between them: lengths and areas, or nodes.
struct Extent {
  double along = 0;
  double inside = 0;
};

/// Estimates the number of sheets at an outline sample: its own and those of the other parts there,
/// probed on both sides.
double nodes_at_outline(const SizeField& field, Point2 a, Point2 b) {
  const double length = std::max(distance(a, b), 1e-300);
  const Point2 aside = (1.5 * field.cell / length) * Point2{a.y - b.y, b.x - a.x};
  return 0.5 * (field.cover_at(a + aside) + field.cover_at(a - aside)) + 0.5;
}

/// Estimates the number of nodes at a spacing x, without triangulating. Along outlines it grows
/// like 1 / x, between them like 1 / x^2.
Result<Extent> estimate_nodes(const Scene& scene, double spacing) {
  const auto sampled = sample_outlines(scene, spacing);
  if (!sampled) return sampled.error();
  const SizeField field = size_field_for(*sampled, spacing);
  Extent nodes;
  std::vector<Point2> points;
  std::vector<std::array<int, 2>> edges;
  for (const InputCurve& curve : sampled->curves) {
    const int first = static_cast<int>(points.size());
    const int n = static_cast<int>(curve.points.size());
    for (int i = 0; i < n; ++i) {
      points.push_back(curve.points[i]);
      edges.push_back({first + i, first + (i + 1) % n});
      nodes.along += nodes_at_outline(field, curve.points[i], curve.points[(i + 1) % n]);
    }
  }
  for (const Point2 p : inner_points(field, points, edges)) nodes.inside += field.cover_at(p);
  return nodes;
}

/// Sums the perimeters and areas of all rings, px and px^2.
Extent measure_outlines(const Scene& scene) {
  Extent extent;
  for (const Part& part : scene.parts)
    for (const Ring& ring : part.outline) {
      extent.along += perimeter(ring);
      extent.inside += std::abs(signed_area(ring));
    }
  return extent;
}

double longer_side(const Box2& box) {
  return std::max(box.max.x - box.min.x, box.max.y - box.min.y);
}

double smallest_spacing(const Scene& scene) {
  Box2 box;
  for (const Part& part : scene.parts) box.add(bounding_box(part.outline));
  return finest_spacing * longer_side(box);
}

/// Refuses spacings that would certainly give more nodes than allowed, before anything is made.
Status check_size(const Scene& scene, double spacing, const LayerOptions& options) {
  const Extent extent = measure_outlines(scene);
  const double coarsest = spacing * max_growth;
  const double least = extent.along / spacing + extent.inside / (coarsest * coarsest);
  if (least > options.max_nodes || options.vertex_budget > options.max_nodes)
    return Error{ErrorCode::limit,
                 "the mesh would have more than " + std::to_string(options.max_nodes) +
                     " vertices; use fewer vertices or longer edges",
                 ""};
  const double finest = smallest_spacing(scene);
  if (spacing < finest)
    return Error{ErrorCode::limit,
                 "the edges are too short for the size of the drawing; use edges of at least " +
                     std::to_string(finest) + " px",
                 ""};
  return Done{};
}

/// Finds the spacing at which the joined mesh has about `budget` nodes.
Result<double> choose_spacing(const Scene& scene, double budget, const RunContext& context) {
  const auto [length, area] = measure_outlines(scene);
  const double finest = smallest_spacing(scene);
  // Twice the plain counts: sheets repeat the outlines of others, and grading thins the inside.
  double spacing =
      std::max(finest, (length + std::sqrt(length * length + 0.3 * budget * area)) / budget);
  for (int round = 0; round < 5; ++round) {
    if (context.cancelled()) return interrupted_error();
    const auto nodes = estimate_nodes(scene, spacing);
    if (!nodes) return nodes.error();
    const auto [along, inside] = *nodes;
    if (std::abs(along + inside - budget) < 0.01 * budget) break;
    // budget = along / x + inside / x^2 for the new spacing x * spacing
    const double factor = (along + std::sqrt(along * along + 4 * budget * inside)) / (2 * budget);
    spacing = std::max(finest, factor * spacing);
  }
  return spacing;
}

std::vector<Outline> outlines_of(const SampledOutlines& sampled) {
  std::vector<Outline> outlines;
  for (size_t c = 0; c < sampled.curves.size(); ++c) {
    const size_t part = sampled.marked.rings[c].part;
    if (part >= outlines.size()) outlines.resize(part + 1);
    outlines[part].push_back(sampled.curves[c].points);
  }
  return outlines;
}

}  // namespace

Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context) {
  double spacing = options.edge_length;
  if (spacing <= 0) {
    const auto chosen = choose_spacing(scene, options.vertex_budget, context);
    if (!chosen) return chosen.error();
    spacing = *chosen;
  }
  if (Status status = check_size(scene, spacing, options); !status) return status.error();
  if (context.cancelled()) return interrupted_error();
  return spacing;
}

SizeField size_field_for(const SampledOutlines& sampled, double spacing) {
  Box2 box;
  for (const CurveSample& sample : sampled.samples) box.add(sample.position);
  SizeOptions size;
  size.grading = grading;
  size.max_size = spacing * max_growth;
  size.cells = std::clamp(static_cast<int>(longer_side(box) / spacing), 64, 2048);
  return make_size_field(sampled.samples, outlines_of(sampled), size);
}

std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges) {
  const SegmentGrid grid(
      edges.size(), [&](size_t e) { return std::pair(points[edges[e][0]], points[edges[e][1]]); });
  const std::vector<Point2> lattice = lattice_points(field);
  std::vector<uint8_t> clear(lattice.size(), 1);
  run_ranges(static_cast<int>(lattice.size()), [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const Point2 p = lattice[i];
      const double clearance = relative_clearance * field.size_at(p);
      grid.for_each_near(p, p, clearance, [&](int e) {
        const auto& [a, b] = edges[e];
        if (clear[i] != 0) clear[i] = distance_to_segment(p, points[a], points[b]) >= clearance;
      });
    }
  });
  std::vector<Point2> kept;
  for (size_t i = 0; i < lattice.size(); ++i)
    if (clear[i] != 0) kept.push_back(lattice[i]);
  return kept;
}

}  // namespace relievo::relief
