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

constexpr std::initializer_list<CueKind> sloping = {CueKind::slope, CueKind::crease};

double tangent(const Cue& cue) { return std::tan(cue.value * M_PI / 180); }

/// A weighted mean of slopes at every vertex.
struct Wanted {
  MatrixXd sum;  ///< #V x 2
  VectorXd weight;

  explicit Wanted(size_t vertices)
      : sum(MatrixXd::Zero(static_cast<Index>(vertices), 2)),
        weight(VectorXd::Zero(static_cast<Index>(vertices))) {}

  void add(int vertex, Point2 slope, double by) {
    sum(vertex, 0) += by * slope.x;
    sum(vertex, 1) += by * slope.y;
    weight[vertex] += by;
  }
};

Wanted wanted_along(const PartSheet& sheet, const std::vector<StrokeContact>& contacts) {
  Wanted wanted(sheet.positions.size());
  for (const StrokeContact& contact : contacts)
    for (const int v : sheet.triangles[contact.triangle])
      wanted.add(v, tangent(*contact.cue) * contact.along, 1);
  return wanted;
}

/// On both sides of each edge of a crease, at its two ends, the slope towards it. Where a crease
/// ends inside the part both sides are one, and cancel.
Wanted wanted_beside_creases(const LayeredMesh& mesh, const Scene& scene, int part,
                             const PartSheet& sheet) {
  Wanted wanted(sheet.positions.size());
  for (const CreaseEdge& edge : mesh.creases)
    for (const int corner : edge.corner) {
      if (mesh.face_part[corner / 3] != part) continue;
      const auto place = std::lower_bound(sheet.faces.begin(), sheet.faces.end(), corner / 3);
      const auto& triangle = sheet.triangles[place - sheet.faces.begin()];
      const int from = triangle[next_place(corner)];
      const int to = triangle[last_place(corner)];
      const Point2 along = sheet.positions[to] - sheet.positions[from];
      const double length = norm(along);
      // The faces run so that cross(along, towards the inside) > 0.
      const Point2 to_crease = 1 / length * Point2{along.y, -along.x};
      for (const int v : {from, to})
        wanted.add(v, tangent(scene.cues[edge.cue]) * to_crease, length);
    }
  return wanted;
}

/// The field at the vertices of a sheet that is cut along its creases, #V x 2.
MatrixXd field_on(const PartSheet& sheet, const Wanted& along, const Wanted& beside) {
  const auto vertices = static_cast<Index>(sheet.positions.size());
  std::vector<uint8_t> fixed = sheet.seam;
  MatrixXd values = MatrixXd::Zero(vertices, 2);
  for (Index v = 0; v < vertices; ++v)
    for (const Wanted* wanted : {&beside, &along}) {
      if (fixed[v] != 0 || wanted->weight[v] == 0) continue;
      values.row(v) = wanted->sum.row(v) / wanted->weight[v];
      fixed[v] = 1;
    }
  return harmonic_extension({sheet.positions, sheet.triangles}, std::move(fixed), std::move(values),
                            0);
}

/// The mean of the field over each triangle.
std::vector<Point2> on_triangles(const PartSheet& sheet, const MatrixXd& field) {
  std::vector<Point2> means;
  means.reserve(sheet.triangles.size());
  for (const auto& [a, b, c] : sheet.triangles) {
    const Eigen::RowVector2d mean = (field.row(a) + field.row(b) + field.row(c)) / 3;
    means.push_back({mean[0], mean[1]});
  }
  return means;
}

/// What the part's lean alone would be.
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

/// b at the vertices of the sheet.
VectorXd bulge_of(const PartSheet& sheet, const std::vector<StrokeContact>& contacts) {
  const auto vertices = static_cast<Eigen::Index>(sheet.positions.size());
  VectorXd sum = VectorXd::Zero(vertices);
  VectorXd weight = VectorXd::Zero(vertices);
  for (const StrokeContact& contact : contacts)
    for (const int v : sheet.triangles[contact.triangle]) {
      sum[v] += contact.cue->value;
      weight[v] += 1;
    }
  std::vector<uint8_t> fixed = sheet.rim;
  VectorXd values = VectorXd::Ones(vertices);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    if (weight[v] == 0 || fixed[v] != 0) continue;
    values[v] = sum[v] / weight[v];
    fixed[v] = 1;
  }
  return harmonic_extension({sheet.positions, sheet.triangles}, std::move(fixed), values, 1);
}

/// The mean over a triangle of the square of a linear function.
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
  const std::vector<bool> wanted = parts_with(scene, sloping);
  if (std::find(wanted.begin(), wanted.end(), true) == wanted.end()) return field;
  const auto cut = part_sheets(mesh, wanted, AcrossCreases::cut, scale);
  const auto whole = part_sheets(mesh, wanted, AcrossCreases::whole, scale);
  for (int part = 0; part < static_cast<int>(cut.size()); ++part) {
    const PartSheet& sheet = cut[part];
    if (sheet.faces.empty()) continue;
    const auto contacts = stroke_contacts(sheet, scene, part, CueKind::slope, scale);
    const std::vector<Point2> added =
        on_triangles(sheet, field_on(sheet, wanted_along(sheet, contacts),
                                     wanted_beside_creases(mesh, scene, part, sheet)));
    const VectorXd rise = nearest_potential({whole[part].positions, whole[part].triangles}, added);
    for (size_t t = 0; t < sheet.faces.size(); ++t) {
      field.slope[sheet.faces[t]] = field.slope[sheet.faces[t]] + added[t];
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
  const std::vector<PartSheet> sheets = part_sheets(mesh, wanted, AcrossCreases::whole, 1);
  for (size_t part = 0; part < sheets.size(); ++part) {
    const PartSheet& sheet = sheets[part];
    if (sheet.faces.empty()) continue;
    const VectorXd b =
        bulge_of(sheet, stroke_contacts(sheet, scene, static_cast<int>(part), CueKind::bulge, 1));
    for (size_t t = 0; t < sheet.faces.size(); ++t) {
      const auto [p, q, r] = sheet.triangles[t];
      factors[sheet.faces[t]] = mean_square(b[p], b[q], b[r]);
    }
  }
  return factors;
}

}  // namespace relievo::relief
