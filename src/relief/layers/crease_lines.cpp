#include "relief/layers/crease_lines.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "kernel/geometry/polyline.h"

namespace relievo::relief {
namespace {

/// Smallest turn of a point that must be a sample, rad (20 degrees).
constexpr double sharp_turn = 0.35;

/// How far a line that ends just short of the outline is extended, of the canvas diagonal.
constexpr double end_reach = 0.01;

/// Shortest edge between a sharp turn and another sample, of the spacing.
constexpr double shortest_edge = 0.3;

/// The line without repeated points, with each end extended by `reach` if that leads out of the
/// part.
std::vector<Point2> extended(std::vector<Point2> line, const Outline& outline, double reach) {
  line.erase(std::unique(line.begin(), line.end()), line.end());
  const double length = line_length(line);
  const Point2 before = point_on_line(line, -reach);
  const Point2 beyond = point_on_line(line, length + reach);
  if (contains(outline, line.front()) && !contains(outline, before)) line.front() = before;
  if (contains(outline, line.back()) && !contains(outline, beyond)) line.back() = beyond;
  return line;
}

/// Arc lengths of the points at which the line turns sharply.
std::vector<double> sharp_turns(const std::vector<Point2>& line) {
  std::vector<double> found;
  double s = 0;
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    const Point2 in = line[i] - line[i - 1];
    const Point2 out = line[i + 1] - line[i];
    s += norm(in);
    if (std::abs(std::atan2(cross(in, out), dot(in, out))) > sharp_turn) found.push_back(s);
  }
  return found;
}

InputCurve sampled_span(const std::vector<Point2>& line, LineSpan span, double spacing) {
  std::vector<double> stops = {span.from};
  for (const double s : sharp_turns(line))
    if (std::min(s - stops.back(), span.to - s) > shortest_edge * spacing) stops.push_back(s);
  stops.push_back(span.to);
  InputCurve curve;
  curve.points.push_back(point_on_line(line, span.from));
  for (size_t i = 1; i < stops.size(); ++i) {
    const double length = stops[i] - stops[i - 1];
    const int pieces = std::max(1, static_cast<int>(std::lround(length / spacing)));
    for (int k = 1; k <= pieces; ++k)
      curve.points.push_back(point_on_line(line, stops[i - 1] + length * k / pieces));
  }
  // No outline moves to a crease.
  curve.kept.assign(curve.points.size(), false);
  return curve;
}

/// The corner of the part's face opposite to its edge from a to b, or -1.
Corner corner_opposite(const SheetMesh& mesh, int part, int a, int b) {
  const int t = mesh.triangle_left_of(a, b);
  const int face = mesh.face_of(t, part);
  return face < 0 ? -1 : corner_of(face, next_place(place_of_node(mesh.base.triangles[t], b)));
}

}  // namespace

void sample_creases(const Scene& scene, double spacing, SampledOutlines& sampled) {
  const double reach = end_reach * std::hypot(scene.width, scene.height);
  for (size_t c = 0; c < scene.cues.size(); ++c) {
    const Cue& cue = scene.cues[c];
    if (cue.kind != CueKind::crease) continue;
    const Outline& outline = scene.parts[cue.part].outline;
    const std::vector<Point2> line = extended(cue.line, outline, reach);
    const double length = line_length(line);
    for (LineSpan span : spans_inside(line, outline)) {
      span = {std::max(0.0, span.from - 0.5 * spacing), std::min(length, span.to + 0.5 * spacing)};
      InputCurve curve = sampled_span(line, span, spacing);
      for (const Point2 p : curve.points) sampled.samples.push_back({p, spacing});
      sampled.creases.push_back(std::move(curve));
      sampled.crease_cue.push_back(static_cast<int>(c));
    }
  }
}

std::vector<CreaseEdge> find_creases(const SheetMesh& mesh,
                                     const std::vector<std::vector<int>>& lines,
                                     const std::vector<int>& cues, const Scene& scene) {
  std::vector<CreaseEdge> creases;
  std::set<int> taken;
  for (size_t i = 0; i < lines.size(); ++i) {
    const int part = scene.cues[cues[i]].part;
    for (size_t k = 0; k + 1 < lines[i].size(); ++k) {
      const Corner ahead = corner_opposite(mesh, part, lines[i][k], lines[i][k + 1]);
      const Corner back = corner_opposite(mesh, part, lines[i][k + 1], lines[i][k]);
      if (ahead < 0 || back < 0 ||
          !share_edge(mesh.faces[triangle_of(ahead)], place_of(ahead),
                      mesh.faces[triangle_of(back)], place_of(back)))
        continue;
      if (taken.insert(std::min(ahead, back)).second) creases.push_back({cues[i], {ahead, back}});
    }
  }
  return creases;
}

}  // namespace relievo::relief
