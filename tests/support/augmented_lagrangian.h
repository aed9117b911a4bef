#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "support/nonlinear_program.h"

namespace relievo::testing {

/// The augmented Lagrangian of the program over x = (f at the unknowns, g), as a function for a
/// descent method [P §4].
class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const NonlinearProgram& program, double penalty)
      : program_(program),
        multipliers_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(program.pairs.size()))),
        penalty_(penalty) {}

  NonlinearPoint point(const Eigen::VectorXd& x) const {
    const auto unknowns = static_cast<Eigen::Index>(program_.node.size());
    NonlinearPoint at{x.head(unknowns), x.tail(x.size() - unknowns)};
    for (int i = 0; i < unknowns; ++i)
      at.p[i] = on_bound(program_, i) ? std::abs(at.p[i]) : at.p[i] * at.p[i];
    return at;
  }

  double operator()(const Eigen::VectorXd& x, Eigen::VectorXd& slope) const {
    const NonlinearPoint at = point(x);
    NonlinearPoint d = gradient(program_, at);
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(d.g.size());
    const double value = energy(program_, at) + penalty_energy(at, pressure);
    for (int i = 0; i < d.p.size(); ++i) {
      const int n = program_.node[i];
      const double chain = on_bound(program_, i) ? std::copysign(1.0, x[i]) : 2 * x[i];
      d.p[i] = chain * d.p[i] + program_.sign[n] * std::copysign(1.0, x[i]) * pressure[n];
    }
    slope.resize(x.size());
    slope << d.p, d.g + pressure;
    return value;
  }

  void update(const Eigen::VectorXd& x) {
    const Eigen::VectorXd h = heights(program_, point(x));
    for (Eigen::Index k = 0; k < multipliers_.size(); ++k) multipliers_[k] = push(k, h);
  }

 private:
  double push(Eigen::Index k, const Eigen::VectorXd& h) const {
    const relief::DepthPair& pair = program_.pairs[k];
    const double push = multipliers_[k] + penalty_ * (h[pair.lower] - h[pair.upper]);
    return pair.equal ? push : std::max(push, 0.0);
  }

  double penalty_energy(const NonlinearPoint& at, Eigen::VectorXd& pressure) const {
    const Eigen::VectorXd h = heights(program_, at);
    double sum = 0;
    for (Eigen::Index k = 0; k < multipliers_.size(); ++k) {
      const double now = push(k, h);
      sum += (now * now - multipliers_[k] * multipliers_[k]) / (2 * penalty_);
      pressure[program_.pairs[k].lower] += now;
      pressure[program_.pairs[k].upper] -= now;
    }
    return sum;
  }

  const NonlinearProgram& program_;
  Eigen::VectorXd multipliers_;
  double penalty_;
};

/// A point as the variables of the augmented Lagrangian, a little off the places where f = 0.
inline Eigen::VectorXd descent_start(const NonlinearProgram& program, const NonlinearPoint& at) {
  Eigen::VectorXd x(at.p.size() + at.g.size());
  x << at.p, at.g;
  for (int i = 0; i < at.p.size(); ++i)
    x[i] = on_bound(program, i) ? x[i] + 0.01 : std::sqrt(x[i]) + 1e-3;
  return x;
}

}  // namespace relievo::testing
