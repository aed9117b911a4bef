#include "relief/ordering/shift_metric.h"

#include "relief/inflation/inflation.h"

namespace relievo {

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

}  // namespace relievo
