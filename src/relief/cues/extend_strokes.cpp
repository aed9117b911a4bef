#include "relief/cues/extend_strokes.h"

#include <algorithm>
#include <array>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "kernel/operators/laplacian.h"

namespace relievo::relief {
namespace {

using CornerPoints = std::array<Point2, 3>;

/// Returns whether all of the triangle lies strictly on one side of the line through a and b.
bool on_one_side(const CornerPoints& triangle, Point2 a, Point2 b) {
  int left = 0;
  int right = 0;
  for (const Point2 p : triangle) {
    const double side = cross(b - a, p - a);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  return left == 3 || right == 3;
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

bool apart(const Box2& a, const Box2& b) {
  return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y;
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

}  // namespace

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
        const auto [x0, x1] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
        const auto [y0, y1] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        if (apart(box, {{x0, y0}, {x1, y1}}) || on_one_side(triangle, a, b) ||
            beyond_an_edge(triangle, a, b))
          continue;
        visit(static_cast<int>(t), cue, 1 / distance(a, b) * (b - a));
      }
    }
  }
}

std::vector<bool> parts_with(const Scene& scene, std::initializer_list<CueKind> kinds) {
  std::vector<bool> found(scene.parts.size(), false);
  for (const Cue& cue : scene.cues)
    if (std::find(kinds.begin(), kinds.end(), cue.kind) != kinds.end()) found[cue.part] = true;
  return found;
}

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

}  // namespace relievo::relief
