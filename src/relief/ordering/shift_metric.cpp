#include "relief/ordering/shift_metric.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// How little the size of the constants counts against their differences.
constexpr double weakest = 1e-6;

/// A piece of the plane: its area, and the integral of a function over it.
struct Piece {
  double area = 0;
  double integral = 0;

  void add(double piece, double mean) {
    area += piece;
    integral += piece * mean;
  }
};

/// The rise of each part over its faces, and by how much it differs between parts that are next to
/// each other in the stack.
struct Cover {
  std::vector<Piece> parts;
  std::map<std::pair<int, int>, Piece> overlaps;  ///< of the lower and the upper part
};

Cover cover_of(const LayeredMesh& mesh, const SlopeField& field, const std::vector<double>& areas) {
  Cover cover{std::vector<Piece>(static_cast<size_t>(mesh.part_count)), {}};
  const auto mean = [&](int f) {
    const auto [a, b, c] = field.rise[f];
    return (a + b + c) / 3;
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
      cover.parts[mesh.face_part[f]].add(areas[f], mean(f));
      if (f > mesh.stack_begin[t])
        cover.overlaps[{mesh.face_part[f - 1], mesh.face_part[f]}].add(areas[f],
                                                                       mean(f) - mean(f - 1));
    }
  return cover;
}

/// The constant of each part, #parts.
VectorXd constants_of(const Cover& cover) {
  const auto count = static_cast<int>(cover.parts.size());
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd force = VectorXd::Zero(count);
  for (int part = 0; part < count; ++part) {
    const Piece& piece = cover.parts[part];
    const double weight = piece.area > 0 ? weakest * piece.area : 1;
    entries.emplace_back(part, part, weight);
    force[part] -= piece.area > 0 ? weight * piece.integral / piece.area : 0;
  }
  for (const auto& [parts, overlap] : cover.overlaps) {
    const auto [lower, upper] = parts;
    entries.emplace_back(lower, lower, overlap.area);
    entries.emplace_back(upper, upper, overlap.area);
    entries.emplace_back(std::max(lower, upper), std::min(lower, upper), -overlap.area);
    force[upper] -= overlap.integral;
    force[lower] += overlap.integral;
  }
  SparseMatrix K(count, count);
  K.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky factor;
  factor.analyse(K);
  return factor.factorise(K) ? factor.solve(force) : VectorXd::Zero(count);
}

}  // namespace

ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon) {
  ShiftMetric metric{discretisation.scale, discretisation.L, {}};
  // What takes no part stays where it is and is coupled to nothing.
  metric.A.diagonal() +=
      discretisation.mass.unaryExpr([&](double mass) { return mass > 0 ? epsilon * mass : 1.0; });
  metric.lean.pull = Eigen::VectorXd::Zero(discretisation.mass.size());
  return metric;
}

void add_wanted(const Eigen::VectorXd& r, ShiftMetric& metric) {
  if (r.isZero(0)) return;
  const Eigen::VectorXd force = metric.A * r;
  metric.lean.constant += r.dot(force) / 2 + r.dot(metric.lean.pull);
  metric.lean.pull += force;
}

Eigen::VectorXd inflated_heights(const std::vector<double>& u) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(u.size()));
  for (Eigen::Index n = 0; n < f.size(); ++n) f[n] = signed_root(u[n]);
  return f;
}

LeanTerm lean_term(const LayeredMesh& mesh, const Scene& scene, double scale, double epsilon) {
  if (!has_slopes(scene))
    return {VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_vertex.size())), 0};
  const std::vector<Point2> positions = node_positions(mesh, scale);
  const FlatMesh flat{positions, mesh.faces};
  const std::vector<double> areas = triangle_areas(flat);
  SlopeField field = slope_field(mesh, scene, scale);
  for (size_t f = 0; f < areas.size(); ++f)
    if (mesh.is_flap(f)) field.slope[f] = {};
  const VectorXd constants = constants_of(cover_of(mesh, field, areas));
  LeanTerm term{divergence_load(flat, field.slope), 0};
  for (size_t f = 0; f < areas.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    term.constant += areas[f] * dot(field.slope[f], field.slope[f]) / 2;
    const double mass = epsilon * areas[f] / 3;
    for (int k = 0; k < 3; ++k) {
      const double target = field.rise[f][k] + constants[mesh.face_part[f]];
      term.pull[mesh.faces[f][k]] += mass * target;
      term.constant += mass * target * target / 2;
    }
  }
  return term;
}

}  // namespace relievo::relief
