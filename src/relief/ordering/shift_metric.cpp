#include "relief/ordering/shift_metric.h"

#include <cmath>

#include "kernel/operators/laplacian.h"
#include "relief/layers/joined_surface.h"

namespace relievo {

ShiftMetric make_shift_metric(const Discretisation& discretisation, double epsilon) {
  ShiftMetric metric{discretisation.scale, discretisation.L};
  metric.A.diagonal() += epsilon * discretisation.mass;
  return metric;
}

ShiftMetric make_shift_metric(const LayeredMesh& mesh, double epsilon) {
  ShiftMetric metric;
  metric.scale = scene_scale(mesh);
  const std::vector<Point2> positions = node_positions(mesh, metric.scale);
  const FlatMesh flat{positions, mesh.faces};
  metric.A = stiffness_matrix(flat);
  metric.A.diagonal() += epsilon * lumped_mass(flat);
  return metric;
}

Eigen::VectorXd inflated_heights(const std::vector<double>& u) {
  Eigen::VectorXd f(static_cast<Eigen::Index>(u.size()));
  for (Eigen::Index n = 0; n < f.size(); ++n) f[n] = std::copysign(std::sqrt(std::abs(u[n])), u[n]);
  return f;
}

}  // namespace relievo
