#include "relief/layers/mesh_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/workers.h"
#include "kernel/geometry/polygon.h"
#include "kernel/meshing/segment_grid.h"

namespace relievo::relief {
namespace {

/// Of the longer side of the drawing: no spacing is smaller. Meshes of millions of nodes are far
/// from it; specks far apart would ask for it.
constexpr double finest_spacing = 1.0 / 16384;

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
  for (const Point2 p : inner_points(field, points, edges)) estimate.inside += field.cover_at(p);
  return estimate;
}

/// Summed perimeters and areas of all rings.
struct Extent {
  double length = 0;
  double area = 0;
  double finest = 0;  ///< smallest spacing
};

Extent measure_outlines(const Scene& scene) {
  Extent extent;
  Box2 box;
  for (const Part& part : scene.parts) {
    box.add(bounding_box(part.outline));
    for (const Ring& ring : part.outline) {
      extent.length += perimeter(ring);
      extent.area += std::abs(signed_area(ring));
    }
  }
  extent.finest = finest_spacing * std::max(box.max.x - box.min.x, box.max.y - box.min.y);
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
  if (spacing < extent.finest)
    return Error{ErrorCode::limit,
                 "the edges are too short for the size of the drawing; use edges of at least " +
                     std::to_string(extent.finest) + " px",
                 ""};
  return Done{};
}

/// The spacing at which the joined mesh has about the wanted number of nodes.
Result<double> choose_spacing(const Scene& scene, const LayerOptions& options,
                              const RunContext& context) {
  const auto [length, area, finest] = measure_outlines(scene);
  const double budget = options.vertex_budget;
  // Twice the plain counts: sheets repeat the outlines of others, and grading thins the inside.
  double spacing =
      std::max(finest, (length + std::sqrt(length * length + 0.3 * budget * area)) / budget);
  for (int round = 0; round < 5; ++round) {
    if (context.cancelled()) return interrupted_error();
    const auto estimate = estimate_nodes(scene, spacing, options);
    if (!estimate) return estimate.error();
    const double along = estimate->along;
    const double inside = estimate->inside;
    if (std::abs(along + inside - budget) < 0.01 * budget) break;
    // budget = along / x + inside / x^2 for the new spacing x * spacing
    const double factor = (along + std::sqrt(along * along + 4 * budget * inside)) / (2 * budget);
    spacing = std::max(finest, factor * spacing);
  }
  return spacing;
}

constexpr double relative_clearance =
    0.62;  // of the wanted size, between inner points and outlines

std::vector<Outline> outlines_of(const SampledOutlines& sampled) {
  std::vector<Outline> outlines;
  for (size_t c = 0; c < sampled.curves.size(); ++c) {
    if (sampled.curve_part[c] >= static_cast<int>(outlines.size()))
      outlines.resize(sampled.curve_part[c] + 1);
    outlines[sampled.curve_part[c]].push_back(sampled.curves[c].points);
  }
  return outlines;
}

}  // namespace

Result<double> mesh_spacing(const Scene& scene, const LayerOptions& options,
                            const RunContext& context) {
  double spacing = options.edge_length;
  if (spacing <= 0) {
    const auto chosen = choose_spacing(scene, options, context);
    if (!chosen) return chosen.error();
    spacing = *chosen;
  }
  if (Status status = check_size(scene, spacing, options); !status) return status.error();
  if (context.cancelled()) return interrupted_error();
  return spacing;
}

SizeField size_field_for(const SampledOutlines& sampled, double spacing,
                         const LayerOptions& options) {
  Box2 box;
  for (const CurveSample& sample : sampled.samples) box.add(sample.position);
  SizeOptions size;
  size.grading = options.grading;
  size.max_size = spacing * options.max_growth;
  const double longest = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
  size.cells = std::clamp(static_cast<int>(longest / spacing), 64, 2048);
  return make_size_field(sampled.samples, outlines_of(sampled), size);
}

std::vector<Point2> inner_points(const SizeField& field, const std::vector<Point2>& points,
                                 const std::vector<std::array<int, 2>>& edges) {
  Box2 box;
  for (const Point2 p : points) box.add(p);
  SegmentGrid grid(box, edges.size());
  grid.build(edges.size(),
             [&](size_t e) { return std::pair(points[edges[e][0]], points[edges[e][1]]); });
  const std::vector<Point2> lattice = lattice_points(field);
  std::vector<uint8_t> clear(lattice.size(), 1);
  run_ranges(static_cast<int>(lattice.size()), [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const Point2 p = lattice[i];
      const double clearance = relative_clearance * field.size_at(p);
      grid.for_cells(p, p, clearance, [&](size_t cell) {
        for (const int* e = grid.begin(cell); clear[i] != 0 && e != grid.end(cell); ++e)
          clear[i] =
              distance_to_segment(p, points[edges[*e][0]], points[edges[*e][1]]) >= clearance;
      });
    }
  });
  std::vector<Point2> kept;
  for (size_t i = 0; i < lattice.size(); ++i)
    if (clear[i] != 0) kept.push_back(lattice[i]);
  return kept;
}

}  // namespace relievo::relief
