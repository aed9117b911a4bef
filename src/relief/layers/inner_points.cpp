#include "relief/layers/inner_points.h"

#include <algorithm>
#include <cstdint>

#include "kernel/base/workers.h"
#include "kernel/geometry/ring_measure.h"
#include "kernel/meshing/segment_grid.h"

namespace relievo {
namespace {

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

}  // namespace relievo
