#include "kernel/solvers/face_solver.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/workers.h"
#include "kernel/cholesky/symmetric_graph.h"

namespace relievo {
namespace {

/// How far from the seeds unknowns may move.
constexpr int rings = 4;
/// In each direction, as long as they look at no more than so many entries of K; at least some.
constexpr int most_sweeps = 100;
constexpr int fewest_sweeps = 5;
constexpr int affordable_entries = 400000;

/// Unknowns with the rows and columns of K that are theirs.
struct Patch {
  std::vector<int> unknowns;  ///< ascending
  std::vector<int> begin;     ///< of each one's neighbours, one more at the end
  std::vector<int> neighbour;
  std::vector<double> entry;  ///< of K, for each neighbour
  std::vector<double> diagonal;
};

Patch patch_around(const std::vector<int>& seeds, const BoundQpPoint& point) {
  const SparseMatrix& K = point.K;
  const SymmetricGraph& graph = point.graph;
  Patch patch;
  patch.unknowns = rows_around(graph, seeds, rings, point.fixed);
  std::vector<int> place(static_cast<size_t>(graph.size()), -1);
  for (size_t p = 0; p < patch.unknowns.size(); ++p) place[patch.unknowns[p]] = static_cast<int>(p);
  patch.begin = {0};
  for (const int i : patch.unknowns) {
    patch.diagonal.push_back(K.valuePtr()[K.outerIndexPtr()[i]]);
    for (int p = graph.begin[i]; p < graph.begin[i + 1]; ++p) {
      if (place[graph.neighbour[p]] < 0) continue;
      patch.neighbour.push_back(place[graph.neighbour[p]]);
      patch.entry.push_back(K.valuePtr()[graph.source[p]]);
    }
    patch.begin.push_back(static_cast<int>(patch.neighbour.size()));
  }
  return patch;
}

/// z and the gradient on a patch.
class Relaxation {
 public:
  Relaxation(const Patch& patch, const BoundQpPoint& point) : patch_(patch) {
    for (const int i : patch.unknowns) {
      bounded_.push_back(point.bounded[i]);
      z_.push_back(point.z[i]);
      gradient_.push_back(point.gradient[i]);
    }
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0 && z_[p] < 0) move_to(p, 0);
  }

  void sweep_to_and_fro() {
    for (int p = 0; p < size(); ++p) relax(p);
    for (int p = size() - 1; p >= 0; --p) relax(p);
  }

  int affordable_sweeps() const {
    const int entries = size() + static_cast<int>(patch_.entry.size());
    return std::clamp(affordable_entries / std::max(1, 2 * entries), fewest_sweeps, most_sweeps);
  }

  ActiveGuess guess() const {
    ActiveGuess guess;
    for (int p = 0; p < size(); ++p) {
      if (bounded_[p] == 0) continue;
      guess.unknowns.push_back(patch_.unknowns[p]);
      guess.active.push_back(z_[p] == 0);
    }
    return guess;
  }

 private:
  int size() const { return static_cast<int>(z_.size()); }

  void relax(int p) {
    const double lowest = z_[p] - gradient_[p] / patch_.diagonal[p];
    move_to(p, bounded_[p] != 0 ? std::max(lowest, 0.0) : lowest);
  }

  void move_to(int p, double z) {
    const double step = z - z_[p];
    if (step == 0) return;
    z_[p] = z;
    gradient_[p] += step * patch_.diagonal[p];
    for (int e = patch_.begin[p]; e < patch_.begin[p + 1]; ++e)
      gradient_[patch_.neighbour[e]] += step * patch_.entry[e];
  }

  const Patch& patch_;
  std::vector<uint8_t> bounded_;
  std::vector<double> z_;
  std::vector<double> gradient_;
};

}  // namespace

using Eigen::VectorXd;

namespace {

constexpr int max_refinements = 4;
/// Residuals within this share of the tolerance need no attention.
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
      same_matrix_(options.same_matrix),
      goes_on_(options.start.size() > 0),
      at_(at) {}

bool FaceSolver::solve(bool last) {
  if (context_.cancelled()) return false;
  ++at_.report.iterations;
  ++at_.report.factorisations;
  if (!factorise()) return false;
  if (!goes_on_ && (at_.report.iterations == 1 || last))
    solve_directly();
  else
    solve_change();
  return at_.z.allFinite();
}

void FaceSolver::smooth() {
  if (goes_on_)
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

/// By the same operations wherever the iterations came from.
void FaceSolver::solve_directly() {
  VectorXd free_b = problem_.b;
  clear_active(free_b);
  at_.z = factor_.solve(free_b, at_.sweep);
  clear_active(at_.z);
  at_.mu = gradient_at(problem_, at_.z);
  rough_ = false;
}

/// From the last point on: where little has changed, most of the solve meets zeros. What it
/// leaves of the free residual is not looked at.
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

/// The free residual but for what needs no attention.
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

bool FaceSolver::factorise() {
  if (same_matrix_) return factor_.refactorise_fixed(problem_.K, at_.active, context_);
  same_matrix_ = true;
  return factor_.refactorise(problem_.K, at_.active, context_);
}

void FaceSolver::clear_active(VectorXd& v) const {
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = at_.active[i] != 0 ? 0 : v[i];
}

ActiveGuess relax_around(const std::vector<int>& seeds, const BoundQpPoint& point) {
  const Patch patch = patch_around(seeds, point);
  Relaxation relaxation(patch, point);
  for (int i = relaxation.affordable_sweeps(); i > 0; --i) relaxation.sweep_to_and_fro();
  return relaxation.guess();
}

}  // namespace relievo
