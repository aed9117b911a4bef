#include "kernel/geometry/ellipse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/base/exact_functions.h"

namespace relievo {
namespace {

constexpr int unknowns = 5;  ///< centre, logarithms of the half axes, angle
/// Axes of up to two to one are equally likely. Beyond, |log(a / b)| - log 2 is normally
/// distributed.
constexpr double usual_elongation = std::numbers::ln2;
constexpr double elongation_deviation = 1;
/// Errors of neighbouring points of a contour are correlated: so many points count as one.
constexpr double correlated_points = 4;
constexpr int max_steps = 25;

using Parameters = Eigen::Matrix<double, unknowns, 1>;

Ellipse ellipse_of(const Parameters& p) {
  return {{p[0], p[1]}, exact::exp(p[2]), exact::exp(p[3]), p[4]};
}

/// Computes first_order_distance, given the unit vector `axis` along axis a.
double distance_along(const Ellipse& ellipse, Point2 axis, Point2 p) {
  const Point2 d = p - ellipse.centre;
  const double u = (axis.x * d.x + axis.y * d.y) / ellipse.a;
  const double v = (axis.x * d.y - axis.y * d.x) / ellipse.b;
  const double r2 = u * u + v * v;
  if (r2 < 1e-18) return -std::min(ellipse.a, ellipse.b);
  // |grad r| = s / r
  const double s2 = u * u / (ellipse.a * ellipse.a) + v * v / (ellipse.b * ellipse.b);
  return (r2 - std::sqrt(r2)) / std::sqrt(s2);
}

/// Computes the deviation from the usual elongation, in standard deviations.
double elongation_residual(const Parameters& p) {
  const double elongation = p[2] - p[3];
  return (elongation - std::clamp(elongation, -usual_elongation, usual_elongation)) /
         elongation_deviation;
}

/// Computes all residuals, in standard deviations: those of the evidence, then the elongation's.
Eigen::VectorXd residuals(const Parameters& p, const EllipseEvidence& evidence) {
  const Ellipse ellipse = ellipse_of(p);
  const Point2 axis = exact::direction_of(ellipse.angle);
  const auto distance = [&](Point2 point) { return distance_along(ellipse, axis, point); };
  const double weight = 1 / (evidence.noise * std::sqrt(correlated_points));
  const auto on = static_cast<Eigen::Index>(evidence.on.size());
  const auto within = static_cast<Eigen::Index>(evidence.within.size());
  const auto without = static_cast<Eigen::Index>(evidence.without.size());
  Eigen::VectorXd r(on + within + without + 1);
  for (Eigen::Index i = 0; i < on; ++i) r[i] = weight * distance(evidence.on[i]);
  for (Eigen::Index i = 0; i < within; ++i)
    r[on + i] = weight * std::max(0.0, distance(evidence.within[i]));
  for (Eigen::Index i = 0; i < without; ++i)
    r[on + within + i] = weight * std::min(0.0, distance(evidence.without[i]));
  r[on + within + without] = elongation_residual(p);
  return r;
}

/// Computes the derivatives of the residuals r at p by forward differences.
Eigen::MatrixXd jacobian(const Parameters& p, const Eigen::VectorXd& r,
                         const EllipseEvidence& evidence) {
  const double size = exact::exp(std::max(p[2], p[3]));
  Eigen::MatrixXd J(r.size(), unknowns);
  for (int k = 0; k < unknowns; ++k) {
    const double step = k < 2 ? 1e-6 * size : 1e-6;
    Parameters moved = p;
    moved[k] += step;
    J.col(k) = (residuals(moved, evidence) - r) / step;
  }
  return J;
}

/// Returns the ellipse whose second moments, when filled, are those of the points.
Parameters start(const EllipseEvidence& evidence) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  double count = 0;
  for (const auto* list : {&evidence.on, &evidence.within})
    for (const Point2 point : *list) {
      const Eigen::Vector2d q(point.x, point.y);
      mean += q;
      second += q * q.transpose();
      ++count;
    }
  mean /= count;
  second = second / count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(second);
  const double minor = std::sqrt(2 * std::max(axes.eigenvalues()[0], 0.25));
  const double major = std::sqrt(2 * std::max(axes.eigenvalues()[1], 0.25));
  const Eigen::Vector2d along = axes.eigenvectors().col(1);
  Parameters p;
  p << mean[0], mean[1], exact::log(major), exact::log(minor), exact::angle_of(along[1], along[0]);
  return p;
}

/// Minimises the sum of the squared residuals from p by the Levenberg-Marquardt method.
Parameters descend(Parameters p, const EllipseEvidence& evidence) {
  Eigen::VectorXd r = residuals(p, evidence);
  double damping = 1e-3;
  for (int step = 0; step < max_steps && damping < 1e9; ++step) {
    const Eigen::MatrixXd J = jacobian(p, r, evidence);
    Eigen::MatrixXd A = J.transpose() * J;
    A.diagonal() += damping * A.diagonal() + Eigen::VectorXd::Constant(unknowns, 1e-12);
    const Parameters moved = p - Parameters(A.ldlt().solve(J.transpose() * r));
    const Eigen::VectorXd trial = residuals(moved, evidence);
    if (!(trial.squaredNorm() < r.squaredNorm())) {
      damping *= 10;
      continue;
    }
    const bool settled = r.squaredNorm() - trial.squaredNorm() < 1e-6 * r.squaredNorm();
    p = moved;
    r = trial;
    damping = std::max(damping / 10, 1e-9);
    if (settled) break;
  }
  return p;
}

}  // namespace

double first_order_distance(const Ellipse& ellipse, Point2 p) {
  return distance_along(ellipse, exact::direction_of(ellipse.angle), p);
}

std::optional<Ellipse> fit_ellipse(const EllipseEvidence& evidence) {
  if (evidence.on.size() < 6) return std::nullopt;
  const Parameters moments = start(evidence);
  Parameters circle = moments;
  circle[3] = circle[2];
  const auto cost = [&](const Parameters& p) { return residuals(p, evidence).squaredNorm(); };
  Parameters best = descend(moments, evidence);
  const Parameters second = descend(circle, evidence);
  if (cost(second) < cost(best)) best = second;
  if (!best.allFinite()) return std::nullopt;
  return ellipse_of(best);
}

Ring ring_of(const Ellipse& ellipse, int points) {
  Ring ring;
  const auto [c, s] = exact::direction_of(ellipse.angle);
  for (int i = 0; i < points; ++i) {
    const Point2 at = exact::direction_of(2 * std::numbers::pi * i / points);
    const double u = ellipse.a * at.x;
    const double v = ellipse.b * at.y;
    ring.push_back({ellipse.centre.x + c * u - s * v, ellipse.centre.y + s * u + c * v});
  }
  return ring;
}

}  // namespace relievo
