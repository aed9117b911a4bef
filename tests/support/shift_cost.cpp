#include "support/shift_cost.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "kernel/operators/gradient.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::testing {
namespace {

using Eigen::VectorXd;

/// Where two parts are next to each other in the stack, or one part's faces.
struct Overlap {
  double area = 0;
  Point2 moment;

  void add(const std::array<Point2, 3>& p) {
    const double piece = cross(p[1] - p[0], p[2] - p[0]) / 2;
    area += piece;
    moment = moment + piece / 3 * (p[0] + p[1] + p[2]);
  }
};

/// The cost of the values at the corners of one face.
class FaceCosts {
 public:
  explicit FaceCosts(const ShiftCost& cost)
      : cost_(cost), positions_(relief::node_positions(cost.mesh, relief::scene_scale(cost.mesh))) {
    // Rows of a least squares problem: mean differences of r, weighted by the roots of areas.
    std::map<std::pair<int, int>, Overlap> overlaps;
    const relief::LayeredMesh& mesh = cost.mesh;
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int f = mesh.stack_begin[t]; f < mesh.stack_begin[t + 1]; ++f) {
        overlaps[{-1, mesh.face_part[f]}].add(corners(static_cast<size_t>(f)));
        if (f > mesh.stack_begin[t])
          overlaps[{mesh.face_part[f - 1], mesh.face_part[f]}].add(corners(static_cast<size_t>(f)));
      }
    Eigen::MatrixXd rows =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(overlaps.size()), mesh.part_count);
    VectorXd wanted(rows.rows());
    Eigen::Index row = 0;
    for (const auto& [parts, overlap] : overlaps) {
      const auto [lower, upper] = parts;
      const double weight = std::sqrt(lower < 0 ? 1e-6 * overlap.area : overlap.area);
      Point2 slope = cost.scene.parts[upper].lean;
      rows(row, upper) = weight;
      if (lower >= 0) {
        rows(row, lower) = -weight;
        slope = slope - cost.scene.parts[lower].lean;
      }
      wanted[row++] = -weight * dot(slope, 1 / overlap.area * overlap.moment);
    }
    constants_ = rows.completeOrthogonalDecomposition().solve(wanted);
  }

  double at(size_t face, const std::array<double, 3>& g) const {
    const std::array<Point2, 3> p = corners(face);
    const int part = cost_.mesh.face_part[face];
    const Point2 lean = cost_.scene.parts[part].lean;
    const std::array<std::array<int, 3>, 1> triangle = {{{0, 1, 2}}};
    const Point2 slope = face_gradients({p, triangle}, g)[0] - lean;
    const double area = cross(p[1] - p[0], p[2] - p[0]) / 2;
    double sum = area * dot(slope, slope) / 2;
    for (int k = 0; k < 3; ++k) {
      const double off = g[k] - dot(lean, p[k]) - constants_[part];
      sum += cost_.epsilon * area / 3 * off * off / 2;
    }
    return sum;
  }

 private:
  std::array<Point2, 3> corners(size_t face) const {
    const std::array<int, 3>& nodes = cost_.mesh.faces[face];
    return {positions_[nodes[0]], positions_[nodes[1]], positions_[nodes[2]]};
  }

  const ShiftCost& cost_;
  std::vector<Point2> positions_;
  VectorXd constants_;  ///< of each part's r
};

std::array<double, 3> values_at(const std::array<int, 3>& nodes, const VectorXd& g) {
  return {g[nodes[0]], g[nodes[1]], g[nodes[2]]};
}

}  // namespace

double ShiftCost::operator()(const VectorXd& g) const {
  const FaceCosts costs(*this);
  double sum = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (!mesh.is_flap(f)) sum += costs.at(f, values_at(mesh.faces[f], g));
  return sum;
}

VectorXd ShiftCost::slope(const VectorXd& g) const {
  const FaceCosts costs(*this);
  VectorXd slope = VectorXd::Zero(g.size());
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.is_flap(f)) continue;
    const std::array<double, 3> values = values_at(mesh.faces[f], g);
    for (int k = 0; k < 3; ++k) {
      std::array<double, 3> ahead = values;
      std::array<double, 3> behind = values;
      ahead[k] += 1;
      behind[k] -= 1;
      slope[mesh.faces[f][k]] += (costs.at(f, ahead) - costs.at(f, behind)) / 2;
    }
  }
  return slope;
}

}  // namespace relievo::testing
