#include "support/shift_cost.h"

#include <array>
#include <vector>

#include "kernel/operators/gradient.h"
#include "relief/layers/joined_surface.h"

namespace relievo::testing {
namespace {

using Eigen::VectorXd;

/// The cost of the values at the corners of one face.
class FaceCosts {
 public:
  explicit FaceCosts(const ShiftCost& cost)
      : cost_(cost),
        positions_(node_positions(cost.mesh, scene_scale(cost.mesh))),
        middle_(static_cast<size_t>(cost.mesh.part_count)) {
    std::vector<double> sum(middle_.size(), 0);
    for (size_t f = 0; f < cost.mesh.faces.size(); ++f) {
      const std::array<Point2, 3> p = corners(f);
      const int part = cost.mesh.face_part[f];
      const double weight = cross(p[1] - p[0], p[2] - p[0]);
      middle_[part] = middle_[part] + weight / 3 * (p[0] + p[1] + p[2]);
      sum[part] += weight;
    }
    for (size_t part = 0; part < sum.size(); ++part)
      if (sum[part] > 0) middle_[part] = 1 / sum[part] * middle_[part];
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
      const double off = g[k] - dot(lean, p[k] - middle_[part]);
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
  std::vector<Point2> middle_;
};

std::array<double, 3> values_at(const std::array<int, 3>& nodes, const VectorXd& g) {
  return {g[nodes[0]], g[nodes[1]], g[nodes[2]]};
}

}  // namespace

double ShiftCost::operator()(const VectorXd& g) const {
  const FaceCosts costs(*this);
  double sum = 0;
  for (size_t f = 0; f < mesh.faces.size(); ++f) sum += costs.at(f, values_at(mesh.faces[f], g));
  return sum;
}

VectorXd ShiftCost::slope(const VectorXd& g) const {
  const FaceCosts costs(*this);
  VectorXd slope = VectorXd::Zero(g.size());
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
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
