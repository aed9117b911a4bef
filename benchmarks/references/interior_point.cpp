#include "benchmarks/references/interior_point.h"

#include <algorithm>
#include <cmath>

#include "kernel/cholesky/sparse_products.h"

namespace relievo::benchmarks {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int max_iterations = 100;
constexpr double tolerance = 1e-10;

/// z and the multipliers s of z >= 0; s is 0 where there is no bound.
struct Point {
  VectorXd z;
  VectorXd s;
};

class InteriorPoint {
 public:
  InteriorPoint(const BoundQp& program, std::span<const int> order)
      : program_(program), A_(program.K) {
    factor_.analyse(A_, Refactorisation::complete, order);
    for (const uint8_t bounded : program.bounded) bounds_ += bounded;
    point_.z = VectorXd::Zero(program.b.size());
    point_.s = point_.z;
    for (Index i = 0; i < point_.z.size(); ++i)
      if (bounded(i)) point_.z[i] = point_.s[i] = 1e-2;
  }

  ReferenceSolution run() {
    ReferenceSolution result;
    while (result.iterations < max_iterations && !result.solved) {
      VectorXd residual = multiply_symmetric(program_.K, point_.z) - program_.b - point_.s;
      for (size_t i = 0; i < program_.fixed.size(); ++i)
        if (program_.fixed[i] != 0) residual[static_cast<Index>(i)] = 0;
      const double gap = bounds_ > 0 ? point_.z.dot(point_.s) / bounds_ : 0;
      result.solved = residual.lpNorm<Eigen::Infinity>() <= tolerance && gap <= tolerance;
      if (result.solved || !factorise()) break;
      ++result.iterations;
      step(residual, gap);
    }
    result.x = point_.z;
    return result;
  }

 private:
  bool bounded(Index i) const { return program_.bounded[i] != 0; }

  bool factorise() {
    for (Index i = 0; i < point_.z.size(); ++i) {
      const int diagonal = A_.outerIndexPtr()[i];
      A_.valuePtr()[diagonal] = program_.K.valuePtr()[diagonal];
      if (bounded(i)) A_.valuePtr()[diagonal] += point_.s[i] / point_.z[i];
    }
    return factor_.factorise(A_, program_.fixed);
  }

  /// Computes the Newton step to z s = target.
  Point direction(const VectorXd& residual, const VectorXd& target) const {
    VectorXd right = -residual;
    for (Index i = 0; i < right.size(); ++i)
      if (bounded(i)) right[i] += target[i] / point_.z[i] - point_.s[i];
    Point d{factor_.solve(right), VectorXd::Zero(right.size())};
    for (Index i = 0; i < right.size(); ++i)
      if (bounded(i)) d.s[i] = (target[i] - point_.s[i] * d.z[i]) / point_.z[i] - point_.s[i];
    return d;
  }

  /// Returns the longest step up to 1 that stays inside the bounds.
  double longest_step(const Point& d) const {
    double length = 1;
    for (Index i = 0; i < d.z.size(); ++i) {
      if (!bounded(i)) continue;
      if (d.z[i] < 0) length = std::min(length, -point_.z[i] / d.z[i]);
      if (d.s[i] < 0) length = std::min(length, -point_.s[i] / d.s[i]);
    }
    return length;
  }

  void step(const VectorXd& residual, double gap) {
    const Point predictor = direction(residual, VectorXd::Zero(residual.size()));
    const double reach = longest_step(predictor);
    double predicted = 0;
    for (Index i = 0; i < residual.size(); ++i)
      if (bounded(i))
        predicted += (point_.z[i] + reach * predictor.z[i]) *
                     (point_.s[i] + reach * predictor.s[i]) / bounds_;
    const double centring = gap > 0 ? std::pow(predicted / gap, 3) * gap : 0;
    VectorXd target = VectorXd::Constant(residual.size(), centring);
    target -= predictor.z.cwiseProduct(predictor.s);
    const Point corrector = direction(residual, target);
    const double length = std::min(1.0, 0.995 * longest_step(corrector));
    point_.z += length * corrector.z;
    point_.s += length * corrector.s;
  }

  const BoundQp& program_;
  SparseMatrix A_;
  SparseCholesky factor_;
  int bounds_ = 0;
  Point point_;
};

}  // namespace

ReferenceSolution solve_by_interior_point(const BoundQp& program, std::span<const int> order) {
  return InteriorPoint(program, order).run();
}

}  // namespace relievo::benchmarks
