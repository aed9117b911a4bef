#include "relief/cues/cue_fields.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "kernel/geometry/region.h"
#include "kernel/geometry/triangles.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/part_sheet.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Called with a triangle of a sheet, a cue, and the unit direction of a segment of its line that
/// meets the triangle.
using StrokeVisitor = std::function<void(int triangle, const Cue& cue, Point2 along)>;

using CornerPoints = std::array<Point2, 3>;

/// Returns whether all of the triangle lies strictly on one side of the line through a and b.
bool on_one_side(const CornerPoints& triangle, Point2 a, Point2 b) {
  const auto side = [&](size_t k) { return cross(b - a, triangle[k] - a); };
  const auto [least, most] = std::minmax({side(0), side(1), side(2)});
  return least > 0 || most < 0;
}

/// Returns whether the segment lies strictly outside one edge of the triangle, whose area is
/// positive.
bool beyond_an_edge(const CornerPoints& triangle, Point2 a, Point2 b) {
  for (int k = 0; k < 3; ++k) {
    const Point2 p = triangle[k];
    const Point2 edge = triangle[next_place(k)] - p;
    if (cross(edge, a - p) < 0 && cross(edge, b - p) < 0) return true;
  }
  return false;
}

/// Solves (L x)_i = load_i at free vertices with x_i = values_i at fixed ones; 0 if L is singular.
MatrixXd solve_fixed(const SparseMatrix& L, const std::vector<uint8_t>& fixed, const MatrixXd& load,
                     const MatrixXd& values) {
  SparseCholesky factor;
  factor.analyse(L);
  MatrixXd x = MatrixXd::Zero(values.rows(), values.cols());
  if (!factor.factorise(L, fixed)) return x;
  for (Index v = 0; v < x.rows(); ++v)
    if (fixed[v] != 0) x.row(v) = values.row(v);
  const MatrixXd right = load - L * x;
  for (Index k = 0; k < x.cols(); ++k) {
    VectorXd b = right.col(k);
    for (Index v = 0; v < b.size(); ++v)
      if (fixed[v] != 0) b[v] = x(v, k);
    x.col(k) = factor.solve(b);
  }
  return x;
}

/// Visits the triangles that the lines of a part's cues of one kind meet, cue by cue and segment by
/// segment. `scale` is that of the sheet. O(K * points of the lines).
void visit_strokes(const PartSheet& sheet, const Scene& scene, int part, CueKind kind, double scale,
                   const StrokeVisitor& visit) {
  for (const Cue& cue : scene.cues) {
    if (cue.part != part || cue.kind != kind) continue;
    for (size_t i = 0; i + 1 < cue.line.size(); ++i) {
      const Point2 a = scale * cue.line[i];
      const Point2 b = scale * cue.line[i + 1];
      if (a == b) continue;
      const Box2 box = bounding_box(Ring{a, b});
      for (size_t t = 0; t < sheet.triangles.size(); ++t) {
        const auto [p, q, r] = sheet.triangles[t];
        const CornerPoints triangle{sheet.positions[p], sheet.positions[q], sheet.positions[r]};
        Box2 around;
        for (const Point2 corner : triangle) around.add(corner);
        if (!boxes_meet(box, around) || on_one_side(triangle, a, b) ||
            beyond_an_edge(triangle, a, b))
          continue;
        visit(static_cast<int>(t), cue, 1 / distance(a, b) * (b - a));
      }
    }
  }
}

/// Flags the parts that have a cue of one of the kinds.
std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds) {
  std::vector<bool> found(scene.parts.size(), false);
  for (const Cue& cue : scene.cues)
    if (std::find(kinds.begin(), kinds.end(), cue.kind) != kinds.end()) found[cue.part] = true;
  return found;
}

/// Computes the discrete harmonic functions x that have given values at fixed vertices and no flow
/// through the rest of the boundary:
///   (L x)_i = 0 at free vertices,  x_i = values_i where fixed.
/// `fixed` has #V flags, `values` #V rows and a column for each function; its other rows are not
/// read. Pieces of the mesh without a fixed vertex get `otherwise`. One factorisation.
MatrixXd harmonic_extension(const FlatMesh& mesh, std::vector<uint8_t> fixed, MatrixXd values,
                            double otherwise) {
  const std::vector<int> piece = connected_pieces(mesh.triangles, mesh.positions.size());
  std::vector<uint8_t> has_fixed(fixed.size(), 0);  // per piece
  for (size_t v = 0; v < fixed.size(); ++v)
    if (fixed[v] != 0) has_fixed[piece[v]] = 1;
  for (size_t v = 0; v < fixed.size(); ++v) {
    if (has_fixed[piece[v]] != 0) continue;
    fixed[v] = 1;
    values.row(static_cast<Index>(v)).setConstant(otherwise);
  }
  return solve_fixed(stiffness_matrix(mesh), fixed, MatrixXd::Zero(values.rows(), values.cols()),
                     values);
}

/// Computes the function r with the gradient nearest to a field w that is constant on each triangle
/// (#F), #V:
///   r = argmin of the integral of |grad r - w|^2,  that is  (L r)_i = integral of w . grad phi_i,
/// with hat functions phi_i. Its mean is 0 on every piece of the mesh. One factorisation.
VectorXd nearest_potential(const FlatMesh& mesh, const std::vector<Point2>& field) {
  const std::vector<int> piece = connected_pieces(mesh.triangles, mesh.positions.size());
  std::vector<uint8_t> fixed(piece.size(), 0);
  for (const int first : piece) fixed[first] = 1;
  const auto vertices = static_cast<Index>(piece.size());
  VectorXd potential = solve_fixed(stiffness_matrix(mesh), fixed, divergence_load(mesh, field),
                                   VectorXd::Zero(vertices));
  const VectorXd mass = lumped_mass(mesh);
  VectorXd area = VectorXd::Zero(vertices);
  VectorXd sum = area;
  for (Index v = 0; v < vertices; ++v) {
    area[piece[v]] += mass[v];
    sum[piece[v]] += mass[v] * potential[v];
  }
  for (Index v = 0; v < vertices; ++v) potential[v] -= sum[piece[v]] / area[piece[v]];
  return potential;
}

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
