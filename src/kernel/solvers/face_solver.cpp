#include "kernel/solvers/face_solver.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/workers.h"
#include "kernel/cholesky/sparse_products.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

constexpr int max_refinements = 4;
/// Residuals below this share of the tolerance are neglected.
constexpr double negligible = 0.1;

}  // namespace

double max_norm(const VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

VectorXd gradient_at(const BoundQp& problem, const VectorXd& z) {
  return multiply_symmetric(problem.K, z) - problem.b;
}

FaceSolver::FaceSolver(const BoundQp& problem, SparseCholesky& factor,
                       const BoundQpOptions& options, const RunContext& context,
                       BoundQpSolution& at)
    : problem_(problem),
      factor_(factor),
      context_(context),
      negligible_(negligible * (options.tolerance * std::max(1.0, max_norm(problem.b)))),
      has_start_(options.start.size() > 0),
      at_(at) {}

bool FaceSolver::solve(bool last) {
  if (context_.cancelled()) return false;
  ++at_.report.iterations;
  ++at_.report.factorisations;
  if (!factor_.refactorise(problem_.K, at_.active, context_)) return false;
  if (!has_start_ && (at_.report.iterations == 1 || last))
    solve_directly();
  else
    solve_change();
  return at_.z.allFinite();
}

void FaceSolver::smooth() {
  if (has_start_)
    at_.mu = gradient_at(problem_, at_.z);
  else
    solve_directly();
}

void FaceSolver::refine() {
  double error = max_norm(free_residual());
  for (int i = 0; i < max_refinements && error > negligible_; ++i) {
    const VectorXd z = at_.z;
    const VectorXd mu = at_.mu;
    at_.z += factor_.solve(free_residual());
    clear_active(at_.z);
    at_.mu = gradient_at(problem_, at_.z);
    const double next = max_norm(free_residual());
    if (!(next < error)) {
      at_.z = z;
      at_.mu = mu;
      return;
    }
    error = next;
  }
}

void FaceSolver::move_to_bound(int i) {
  const SymmetricGraph& graph = factor_.graph();
  const double* K = problem_.K.valuePtr();
  const double step = -at_.z[i];
  at_.z[i] = 0;
  at_.mu[i] += step * K[problem_.K.outerIndexPtr()[i]];
  for (int p = graph.begin[i]; p < graph.begin[i + 1]; ++p)
    at_.mu[graph.neighbour[p]] += step * K[graph.source[p]];
}

VectorXd FaceSolver::free_residual() const {
  VectorXd residual = -at_.mu;
  clear_active(residual);
  return residual;
}

/// Solves for z, by the same operations whatever the last point was.
void FaceSolver::solve_directly() {
  VectorXd free_b = problem_.b;
  clear_active(free_b);
  at_.z = factor_.solve(free_b);
  clear_active(at_.z);
  at_.mu = gradient_at(problem_, at_.z);
  rough_ = false;
}

/// Solves for the step from the last point. Where little has changed, most of the right-hand side
/// is zero, and the solve skips it. Does not compute the free residual that the step leaves.
void FaceSolver::solve_change() {
  for (int i = 0; i < static_cast<int>(at_.z.size()); ++i)
    if (problem_.bounded[i] != 0 && at_.active[i] != 0 && at_.z[i] != 0) move_to_bound(i);
  const VectorXd residual = large_free_residual();
  const VectorXd step = factor_.solve(residual);
  run_ranges(static_cast<int>(step.size()), [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      at_.z[i] += step[i];
      at_.mu[i] +=
          at_.active[i] != 0 ? multiply_row(problem_.K, factor_.graph(), i, step) : residual[i];
    }
  });
  rough_ = true;
}

/// Returns the free residual without its negligible entries.
VectorXd FaceSolver::large_free_residual() const {
  VectorXd residual(at_.mu.size());
  run_ranges(static_cast<int>(residual.size()), [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const bool counts = at_.active[i] == 0 && std::abs(at_.mu[i]) > negligible_;
      residual[i] = counts ? -at_.mu[i] : 0;
    }
  });
  return residual;
}

void FaceSolver::clear_active(VectorXd& v) const {
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = at_.active[i] != 0 ? 0 : v[i];
}

}  // namespace relievo
