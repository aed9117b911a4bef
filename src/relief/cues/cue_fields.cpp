#include "relief/cues/cue_fields.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "relief/cues/extend_strokes.h"
#include "relief/cues/part_sheet.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double tangent(const Cue& cue) { return std::tan(cue.value * M_PI / 180); }

/// Weighted means of vectors at the vertices of a sheet.
struct VertexMeans {
  MatrixXd sum;     ///< #V rows, weighted
  VectorXd weight;  ///< #V

  VertexMeans(const PartSheet& sheet, Index columns)
      : sum(MatrixXd::Zero(static_cast<Index>(sheet.positions.size()), columns)),
        weight(VectorXd::Zero(sum.rows())) {}

  void add(int vertex, const Eigen::RowVectorXd& value, double by) {
    sum.row(vertex) += by * value;
    weight[vertex] += by;
  }

  /// Fixes the vertices that have a mean and are not fixed yet at that value.
  void fix(std::vector<uint8_t>& fixed, MatrixXd& values) const {
    for (Index v = 0; v < weight.size(); ++v) {
      if (fixed[v] != 0 || weight[v] == 0) continue;
      values.row(v) = sum.row(v) / weight[v];
      fixed[v] = 1;
    }
  }
};

VertexMeans slopes_along(const PartSheet& sheet, const Scene& scene, int part, double scale) {
  VertexMeans means(sheet, 2);
  visit_strokes(sheet, scene, part, CueKind::slope, scale,
                [&](int triangle, const Cue& cue, Point2 along) {
                  const Point2 slope = tangent(cue) * along;
                  for (const int v : sheet.triangles[triangle])
                    means.add(v, Eigen::RowVector2d(slope.x, slope.y), 1);
                });
  return means;
}

/// The slopes towards creases at the ends of their edges, on both sides. Where a crease ends inside
/// the part both sides share a vertex, and their slopes cancel.
VertexMeans slopes_to_creases(const LayeredMesh& mesh, const Scene& scene, int part,
                              const PartSheet& sheet) {
  VertexMeans means(sheet, 2);
  for (const CreaseEdge& edge : mesh.creases)
    for (const Corner corner : edge.corner) {
      const int face = triangle_of(corner);
      if (mesh.face_part[face] != part) continue;
      const auto at = std::lower_bound(sheet.faces.begin(), sheet.faces.end(), face);
      const auto& triangle = sheet.triangles[at - sheet.faces.begin()];
      const int from = triangle[next_place(corner)];
      const int to = triangle[last_place(corner)];
      const Point2 along = sheet.positions[to] - sheet.positions[from];
      const double length = norm(along);
      // Triangles have positive area, so their inside is where cross(along, .) > 0.
      const Point2 to_crease = 1 / length * Point2{along.y, -along.x};
      const Point2 slope = tangent(scene.cues[edge.cue]) * to_crease;
      for (const int v : {from, to}) means.add(v, Eigen::RowVector2d(slope.x, slope.y), length);
    }
  return means;
}

/// w at the vertices of a sheet that is cut along its creases, #V x 2.
MatrixXd field_on(const LayeredMesh& mesh, const Scene& scene, int part, const PartSheet& sheet,
                  double scale) {
  std::vector<uint8_t> fixed = sheet.seam;
  MatrixXd values = MatrixXd::Zero(static_cast<Index>(sheet.positions.size()), 2);
  slopes_to_creases(mesh, scene, part, sheet).fix(fixed, values);
  slopes_along(sheet, scene, part, scale).fix(fixed, values);
  return harmonic_extension({sheet.positions, sheet.triangles}, std::move(fixed), std::move(values),
                            0);
}

/// Averages the field over each triangle.
std::vector<Point2> on_triangles(const PartSheet& sheet, const MatrixXd& field) {
  std::vector<Point2> means;
  means.reserve(sheet.triangles.size());
  for (const auto& [a, b, c] : sheet.triangles) {
    const Eigen::RowVector2d mean = (field.row(a) + field.row(b) + field.row(c)) / 3;
    means.push_back({mean[0], mean[1]});
  }
  return means;
}

/// The field of the parts' leans alone: v = lean, rise = lean . x.
SlopeField lean_field(const LayeredMesh& mesh, const Scene& scene, double scale) {
  SlopeField field;
  field.slope.reserve(mesh.faces.size());
  field.rise.reserve(mesh.faces.size());
  const std::vector<Point2> positions = node_positions(mesh, scale);
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const Point2 lean = scene.parts[mesh.source(f)].lean;
    field.slope.push_back(lean);
    const auto [a, b, c] = mesh.faces[f];
    field.rise.push_back(
        {dot(lean, positions[a]), dot(lean, positions[b]), dot(lean, positions[c])});
  }
  return field;
}

/// b at the vertices of a sheet.
VectorXd bulge_of(const PartSheet& sheet, const Scene& scene, int part) {
  VertexMeans means(sheet, 1);
  visit_strokes(sheet, scene, part, CueKind::bulge, 1, [&](int triangle, const Cue& cue, Point2) {
    for (const int v : sheet.triangles[triangle])
      means.add(v, Eigen::RowVectorXd::Constant(1, cue.value), 1);
  });
  std::vector<uint8_t> fixed = sheet.rim;
  MatrixXd values = MatrixXd::Ones(means.sum.rows(), 1);
  means.fix(fixed, values);
  return harmonic_extension({sheet.positions, sheet.triangles}, std::move(fixed), std::move(values),
                            1);
}

/// The mean of b^2 over a triangle on which b is linear, from its values at the corners.
double mean_square(double a, double b, double c) {
  return (a * a + b * b + c * c + a * b + b * c + c * a) / 6;
}

}  // namespace

bool has_slopes(const Scene& scene) {
  const auto leans = [](const Part& part) { return part.lean != Point2{}; };
  const auto slopes = [](const Cue& cue) { return cue.kind != CueKind::bulge; };
  return std::any_of(scene.parts.begin(), scene.parts.end(), leans) ||
         std::any_of(scene.cues.begin(), scene.cues.end(), slopes);
}

SlopeField slope_field(const LayeredMesh& mesh, const Scene& scene, double scale) {
  SlopeField field = lean_field(mesh, scene, scale);
  const std::vector<bool> wanted = parts_with(scene, {CueKind::slope, CueKind::crease});
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return field;
  const std::vector<PartSheet> cut = part_sheets(mesh, wanted, true, scale);
  const std::vector<PartSheet> whole = part_sheets(mesh, wanted, false, scale);
  for (int part = 0; part < static_cast<int>(cut.size()); ++part) {
    const PartSheet& sheet = cut[part];
    if (sheet.faces.empty()) continue;
    const std::vector<Point2> w = on_triangles(sheet, field_on(mesh, scene, part, sheet, scale));
    const VectorXd rise = nearest_potential({whole[part].positions, whole[part].triangles}, w);
    for (size_t t = 0; t < sheet.faces.size(); ++t) {
      field.slope[sheet.faces[t]] = field.slope[sheet.faces[t]] + w[t];
      for (int k = 0; k < 3; ++k)
        field.rise[sheet.faces[t]][k] += rise[whole[part].triangles[t][k]];
    }
  }
  return field;
}

std::vector<double> bulge_factors(const LayeredMesh& mesh, const Scene& scene) {
  const std::vector<bool> wanted = parts_with(scene, {CueKind::bulge});
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return {};
  std::vector<double> factors(mesh.faces.size(), 1);
  const std::vector<PartSheet> sheets = part_sheets(mesh, wanted, false, 1);
  for (int part = 0; part < static_cast<int>(sheets.size()); ++part) {
    const PartSheet& sheet = sheets[part];
    if (sheet.faces.empty()) continue;
    const VectorXd b = bulge_of(sheet, scene, part);
    for (size_t t = 0; t < sheet.faces.size(); ++t) {
      const auto [p, q, r] = sheet.triangles[t];
      factors[sheet.faces[t]] = mean_square(b[p], b[q], b[r]);
    }
  }
  return factors;
}

}  // namespace relievo::relief
