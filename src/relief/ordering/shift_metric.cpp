// The cost of a shift g [P eq 10, 12], in scene units:
//
//   1/2 g'A g - b'g + constant  =  1/2 sum over parts of integral |grad g - t|^2 + eps |g - r|^2
//
//   A = L + eps M
//   b_i = sum over parts of integral t . grad phi_i + eps r phi_i
//   constant = 1/2 sum over parts of integral |t|^2 + eps r^2
//
// A further wanted shift r (limbs, caps, spots) changes b by A r and the constant by
// 1/2 r'A r + b'r.
//
//   letter     in the code
//   A, b       ShiftMetric::A, b
//   t          SlopeField::slope
//   r          SlopeField::rise + part_constants; r in add_wanted

#include "relief/ordering/shift_metric.h"

#include <algorithm>
#include <map>
#include <utility>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"
#include "relief/inflation/inflation.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Weight of the size of the constants against their differences.
constexpr double weakest = 1e-6;

/// The integral of a function over an area of the canvas.
struct Piece {
  double area = 0;
  double integral = 0;

  void add(double piece, double mean) {
    area += piece;
    integral += piece * mean;
  }
};

/// Solves K c = force for the constant c of each part:
///   min sum over overlaps of area (c_upper - c_lower + mean difference of the rise)^2
///     + weakest sum over parts of area (c + mean rise)^2
VectorXd solve_constants(const std::vector<Piece>& parts,
                         const std::map<std::pair<int, int>, Piece>& overlaps) {
  const auto count = static_cast<int>(parts.size());
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd force = VectorXd::Zero(count);
  for (int part = 0; part < count; ++part) {
    const Piece& piece = parts[part];
    const double weight = piece.area > 0 ? weakest * piece.area : 1;
    entries.emplace_back(part, part, weight);
    force[part] -= piece.area > 0 ? weight * piece.integral / piece.area : 0;
  }
  for (const auto& [pair, overlap] : overlaps) {
    const auto [lower, upper] = pair;
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

/// Returns the constant of the rise of each part, #parts. Overlaps are those of parts that are next
/// to each other in the stack.
VectorXd part_constants(const LayeredMesh& mesh, const SlopeField& field,
                        const std::vector<double>& areas) {
  std::vector<Piece> parts(static_cast<size_t>(mesh.part_count));
  std::map<std::pair<int, int>, Piece> overlaps;  // of the lower and the upper part
  const auto mean = [&](int f) {
    const auto [a, b, c] = field.rise[f];
    return (a + b + c) / 3;
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
      parts[mesh.face_part[f]].add(areas[f], mean(f));
      if (f > mesh.stack_begin[t])
        overlaps[{mesh.face_part[f - 1], mesh.face_part[f]}].add(areas[f], mean(f) - mean(f - 1));
    }
  return solve_constants(parts, overlaps);
}

}  // namespace

ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon) {
  ShiftMetric metric{discretisation.scale, discretisation.L, {}, 0};
  // Nodes without mass (inside flaps) stay where they are and are coupled to nothing.
  metric.A.diagonal() +=
      discretisation.mass.unaryExpr([&](double mass) { return mass > 0 ? epsilon * mass : 1.0; });
  metric.b = VectorXd::Zero(discretisation.mass.size());
  return metric;
}

void add_wanted(const VectorXd& r, ShiftMetric& metric) {
  if (r.isZero(0)) return;
  const VectorXd force = metric.A * r;
  metric.constant += r.dot(force) / 2 + r.dot(metric.b);
  metric.b += force;
}

VectorXd inflated_heights(const std::vector<double>& u) {
  VectorXd f(static_cast<Eigen::Index>(u.size()));
  for (Eigen::Index n = 0; n < f.size(); ++n) f[n] = signed_root(u[n]);
  return f;
}

void set_slopes(const LayeredMesh& mesh, const Scene& scene, double epsilon, ShiftMetric& metric) {
  metric.b = VectorXd::Zero(metric.A.rows());
  metric.constant = 0;
  if (!has_slopes(scene)) return;
  const std::vector<Point2> positions = node_positions(mesh, metric.scale);
  const FlatMesh flat{positions, mesh.faces};
  const std::vector<double> areas = triangle_areas(flat);
  SlopeField field = slope_field(mesh, scene, metric.scale);
  for (size_t f = 0; f < areas.size(); ++f)
    if (mesh.is_flap(f)) field.slope[f] = {};
  const VectorXd constants = part_constants(mesh, field, areas);
  metric.b = divergence_load(flat, field.slope);
  for (size_t f = 0; f < areas.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    metric.constant += areas[f] * dot(field.slope[f], field.slope[f]) / 2;
    const double mass = epsilon * areas[f] / 3;
    for (int k = 0; k < 3; ++k) {
      const double r = field.rise[f][k] + constants[mesh.face_part[f]];
      metric.b[mesh.faces[f][k]] += mass * r;
      metric.constant += mass * r * r / 2;
    }
  }
}

}  // namespace relievo::relief
