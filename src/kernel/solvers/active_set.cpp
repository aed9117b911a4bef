#include "kernel/solvers/active_set.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "kernel/cholesky/sparse_products.h"
#include "kernel/cholesky/symmetric_graph.h"
#include "kernel/solvers/face_solver.h"

namespace relievo {
namespace {

/// Steps in the graph from the seeds within which unknowns are relaxed.
constexpr int rings = 4;
/// Sweeps in each direction: as many as look at so many entries of K, within bounds.
constexpr int affordable_entries = 400000;
constexpr int most_sweeps = 100;
constexpr int fewest_sweeps = 5;

/// The unknowns around the seeds, with their rows and columns of K, z and the gradient.
class Patch {
 public:
  Patch(const std::vector<int>& seeds, const BoundQp& problem, const SymmetricGraph& graph,
        const BoundQpSolution& at)
      : unknowns_(rows_around(graph, seeds, rings, problem.fixed)) {
    read_matrix(problem.K, graph);
    for (const int i : unknowns_) {
      bounded_.push_back(problem.bounded[i]);
      z_.push_back(at.z[i]);
      gradient_.push_back(at.mu[i]);
    }
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0 && z_[p] < 0) move_to(p, 0);
  }

  void sweep_in_both_directions() {
    for (int p = 0; p < size(); ++p) relax(p);
    for (int p = size() - 1; p >= 0; --p) relax(p);
  }

  int affordable_sweeps() const {
    const int entries = size() + static_cast<int>(entry_.size());
    return std::clamp(affordable_entries / std::max(1, 2 * entries), fewest_sweeps, most_sweeps);
  }

  /// Makes the bounds with z = 0 active, and no others of the patch.
  void write_active(std::vector<uint8_t>& active) const {
    for (int p = 0; p < size(); ++p)
      if (bounded_[p] != 0) active[unknowns_[p]] = z_[p] == 0;
  }

 private:
  int size() const { return static_cast<int>(unknowns_.size()); }

  void read_matrix(const SparseMatrix& K, const SymmetricGraph& graph) {
    std::vector<int> index(static_cast<size_t>(graph.size()), -1);
    for (int p = 0; p < size(); ++p) index[unknowns_[p]] = p;
    for (const int i : unknowns_) {
      diagonal_.push_back(K.valuePtr()[K.outerIndexPtr()[i]]);
      for (int e = graph.begin[i]; e < graph.begin[i + 1]; ++e) {
        if (index[graph.neighbour[e]] < 0) continue;
        neighbour_.push_back(index[graph.neighbour[e]]);
        entry_.push_back(K.valuePtr()[graph.source[e]]);
      }
      begin_.push_back(static_cast<int>(neighbour_.size()));
    }
  }

  void relax(int p) {
    const double lowest = z_[p] - gradient_[p] / diagonal_[p];
    move_to(p, bounded_[p] != 0 ? std::max(lowest, 0.0) : lowest);
  }

  void move_to(int p, double z) {
    const double step = z - z_[p];
    if (step == 0) return;
    z_[p] = z;
    gradient_[p] += step * diagonal_[p];
    for (int e = begin_[p]; e < begin_[p + 1]; ++e) gradient_[neighbour_[e]] += step * entry_[e];
  }

  std::vector<int> unknowns_;  ///< ascending
  std::vector<double> diagonal_;
  std::vector<int> begin_ = {0};  ///< of the neighbours of each unknown
  std::vector<int> neighbour_;    ///< index in the patch
  std::vector<double> entry_;     ///< of K, for each neighbour
  std::vector<uint8_t> bounded_;
  std::vector<double> z_;
  std::vector<double> gradient_;
};

/// Guesses the active bounds around the unknowns `seeds`: writes at.active, given at.z and, in
/// at.mu, the gradient K z - b. `graph` is that of K.
///
/// Relaxes all unknowns within a few steps of the seeds in the graph by projected Gauss-Seidel
/// sweeps in both directions,
///   z_i := max(0, z_i - g_i / K_ii)   (without the maximum where i is not bounded),
/// while the others are fixed; the fewer unknowns, the more sweeps. A step of a primal-dual active
/// set moves the border of a contact by one gap; the sweeps move it as far as the values around it
/// imply. Both together are a truncated non-smooth Newton method (Graeser and Kornhuber 2009).
/// O(n + sweeps * entries around the seeds).
void relax_around(const std::vector<int>& seeds, const BoundQp& problem,
                  const SymmetricGraph& graph, BoundQpSolution& at) {
  Patch patch(seeds, problem, graph, at);
  for (int i = patch.affordable_sweeps(); i > 0; --i) patch.sweep_in_both_directions();
  patch.write_active(at.active);
}

using Eigen::VectorXd;

/// Iterations in a row in which the number of wrong bounds may fail to fall.
constexpr int block_tries = 3;
/// How often that number may grow without counting as one of them.
constexpr int max_leaps = 2;
/// With so few wrong bounds the next solve is likely to be the last.
constexpr size_t few = 8;

/// Sets negative bounded unknowns to 0.
void project(const BoundQp& problem, VectorXd& z) {
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (problem.bounded[i] != 0) z[i] = std::max(z[i], 0.0);
}

/// Moves z to the lowest point along the negative gradient of the bounds `pulling`.
void release(const BoundQp& problem, const std::vector<int>& pulling, const VectorXd& mu,
             VectorXd& z) {
  VectorXd direction = VectorXd::Zero(z.size());
  for (const int i : pulling) direction[i] = -mu[i];
  const double curvature = direction.dot(multiply_symmetric(problem.K, direction));
  z += direction.squaredNorm() / curvature * direction;
}

/// Returns the longest of the steps 1, 1/2, 1/4, ... along the projected direction that lowers the
/// energy, or else the step to the first bound.
VectorXd projected_step(const BoundQp& problem, const VectorXd& z, const VectorXd& direction) {
  double to_bound = 1;
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (problem.bounded[i] != 0 && direction[i] < 0)
      to_bound = std::min(to_bound, -z[i] / direction[i]);
  const VectorXd gradient = gradient_at(problem, z);
  for (double length = 1; length > to_bound; length /= 2) {
    VectorXd end = z + length * direction;
    project(problem, end);
    const VectorXd step = end - z;
    if (step.dot(gradient + 0.5 * multiply_symmetric(problem.K, step)) < 0) return step;
  }
  VectorXd end = z + to_bound * direction;
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (direction[i] < 0 && -z[i] / direction[i] <= to_bound && problem.bounded[i] != 0) end[i] = 0;
  return end - z;
}

/// Guesses active bounds until none is on the wrong side. solution_.mu is the gradient until the
/// end.
class ActiveSetSolver {
 public:
  ActiveSetSolver(const BoundQp& problem, SparseCholesky& factor, BoundQpOptions options,
                  const RunContext& context)
      : problem_(problem),
        graph_(factor.graph()),
        context_(context),
        scale_(std::max(1.0, max_norm(problem.b))),
        tolerance_(options.tolerance * scale_),
        max_iterations_(options.max_iterations),
        refines_(options.refine || options.start.size() == 0),
        face_(problem, factor, options, context, solution_) {
    const auto n = static_cast<size_t>(problem.b.size());
    assert(problem.bounded.size() == n);
    assert(factor.graph().size() == problem.b.size());
    assert(options.start_active.empty() || options.start_active.size() == n);
    assert(problem.fixed.empty() || problem.fixed.size() == n);
    solution_.active = problem.fixed;
    solution_.active.resize(n, 0);
    for (size_t i = 0; i < n; ++i)
      if (problem.bounded[i] != 0) bounds_.push_back(static_cast<int>(i));
    if (!options.start_active.empty())
      for (const int i : bounds_) solution_.active[i] = options.start_active[i];
    const bool has_start = options.start.size() > 0;
    solution_.z = has_start ? std::move(options.start) : VectorXd::Zero(problem.b.size());
    if (options.start_gradient.size() > 0)
      solution_.mu = std::move(options.start_gradient);
    else
      solution_.mu = has_start ? gradient_at(problem_, solution_.z) : solution_.z;
  }

  BoundQpSolution run() {
    SolveStatus status = pivot_blocks();
    if (status == SolveStatus::iteration_limit) status = descend();
    if (context_.cancelled()) status = SolveStatus::interrupted;
    solution_.report.status = status;
    snap_to_bounds();
    finish_report();
    return std::move(solution_);
  }

 private:
  /// Guesses around all wrong bounds at a time, or flips them where that did not reduce their
  /// number. Returns iteration_limit also where neither makes progress.
  SolveStatus pivot_blocks() {
    size_t fewest = problem_.bounded.size() + 1;
    int tries = block_tries;
    int leaps = max_leaps;
    while (solution_.report.iterations < max_iterations_) {
      if (!face_.solve(few_wrong_)) return SolveStatus::not_positive_definite;
      const std::vector<int> wrong = refined_wrong_bounds();
      if (wrong.empty()) return SolveStatus::solved;
      few_wrong_ = wrong.size() <= few;
      if (wrong.size() < fewest) {
        fewest = wrong.size();
        tries = block_tries;
        guess_around(wrong);
      } else if (wrong.size() > fewest && --leaps >= 0) {
        fewest = wrong.size();
        catch_deepest(wrong);
      } else if (--tries >= 0) {
        flip(wrong);
      } else {
        break;
      }
    }
    return SolveStatus::iteration_limit;
  }

  /// Moves from one feasible point to a lower one: towards the minimiser of the face of its zero
  /// bounds, or off that face where it is reached. No face's minimiser occurs twice.
  SolveStatus descend() {
    VectorXd z = solution_.z;
    project(problem_, z);
    while (solution_.report.iterations < max_iterations_) {
      activate_zeros(z);
      if (!face_.solve(few_wrong_)) return SolveStatus::not_positive_definite;
      ++solution_.report.safeguard_steps;
      const std::vector<int> wrong = refined_wrong_bounds();
      if (wrong.empty()) return SolveStatus::solved;
      if (is_feasible()) {
        z = solution_.z;
        project(problem_, z);
        release(problem_, wrong, solution_.mu, z);
      } else {
        z += projected_step(problem_, z, solution_.z - z);
      }
    }
    return SolveStatus::iteration_limit;
  }

  /// Returns the bounds on the wrong side. That there are none is decided on refined values.
  std::vector<int> refined_wrong_bounds() {
    std::vector<int> wrong = wrong_bounds();
    if (!refines_) return wrong;
    if (wrong.empty() && face_.is_rough()) {
      face_.smooth();
      wrong = wrong_bounds();
    }
    if (!wrong.empty()) return wrong;
    face_.refine();
    return wrong_bounds();
  }

  bool is_feasible() const {
    return std::none_of(bounds_.begin(), bounds_.end(),
                        [&](int i) { return solution_.z[i] < -tolerance_; });
  }

  void activate_zeros(const VectorXd& z) {
    for (const int i : bounds_) solution_.active[i] = z[i] == 0;
  }

  void flip(const std::vector<int>& bounds) {
    for (const int i : bounds) solution_.active[i] = solution_.active[i] == 0;
  }

  /// Guesses after a leap: a part that lost its last active bound violates many bounds at once, of
  /// which few will stop it. Makes the wrong bounds active whose violation is the largest among
  /// their neighbours.
  void catch_deepest(const std::vector<int>& wrong) {
    const auto deepest = [&](int i) {
      const int* first = &graph_.neighbour[graph_.begin[i]];
      return std::none_of(first, first + (graph_.begin[i + 1] - graph_.begin[i]), [&](int j) {
        return problem_.bounded[j] != 0 &&
               (solution_.z[j] < solution_.z[i] || (solution_.z[j] == solution_.z[i] && j < i));
      });
    };
    for (const int i : wrong) solution_.active[i] = solution_.active[i] == 0 && deepest(i);
  }

  void guess_around(const std::vector<int>& wrong) {
    if (is_dense()) return flip(wrong);
    relax_around(wrong, problem_, graph_, solution_);
  }

  /// Returns whether most unknowns are neighbours: then a solve costs no more than relaxing.
  bool is_dense() const {
    const double size = static_cast<double>(problem_.b.size());
    return static_cast<double>(graph_.neighbour.size()) > 0.5 * size * size;
  }

  std::vector<int> wrong_bounds() const {
    std::vector<int> wrong;
    for (const int i : bounds_) {
      const double value = solution_.active[i] != 0 ? solution_.mu[i] : solution_.z[i];
      if (value < -tolerance_) wrong.push_back(i);
    }
    return wrong;
  }

  /// Makes bounds active that round-off left barely on the wrong side, so that z >= 0 exactly.
  void snap_to_bounds() {
    for (const int i : bounds_) {
      if (solution_.z[i] > 0 || solution_.z[i] < -tolerance_) continue;
      if (solution_.z[i] != 0) face_.move_to_bound(i);
      solution_.active[i] = 1;
    }
  }

  void finish_report() {
    BoundQpReport& report = solution_.report;
    VectorXd& mu = solution_.mu;
    solution_.gradient = mu;
    report.energy = 0.5 * solution_.z.dot(mu - problem_.b);
    report.stationarity = max_norm(face_.free_residual());
    for (Eigen::Index i = 0; i < mu.size(); ++i) mu[i] = solution_.active[i] != 0 ? mu[i] : 0;
    for (const int i : bounds_) {
      const double z = solution_.z[i];
      report.active += solution_.active[i] != 0;
      report.primal = std::max(report.primal, -z);
      report.dual = std::max(report.dual, -mu[i]);
      report.complementarity = std::max(report.complementarity, std::abs(z * mu[i]));
    }
    for (double* worst :
         {&report.stationarity, &report.primal, &report.dual, &report.complementarity})
      *worst /= scale_;
  }

  const BoundQp& problem_;
  const SymmetricGraph& graph_;
  const RunContext& context_;
  double scale_;
  double tolerance_;
  int max_iterations_;
  bool refines_;
  bool few_wrong_ = false;   ///< after the last step
  std::vector<int> bounds_;  ///< unknowns that are bounded, ascending
  BoundQpSolution solution_;
  FaceSolver face_;
};

}  // namespace

BoundQpSolution solve_bound_qp(const BoundQp& problem, SparseCholesky& factor,
                               BoundQpOptions options, const RunContext& context) {
  return ActiveSetSolver(problem, factor, std::move(options), context).run();
}

}  // namespace relievo
