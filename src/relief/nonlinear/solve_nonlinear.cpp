// Inflation and depth order at once [P eq 3-6], in scene units:
//
//   minimise  E = (M^-1 L u - c)' M (M^-1 L u - c) + lambda_bnd sum over B of m |u|
//                 + lambda_shift (g'(L + eps M) g - 2 b'g)
//   subject to h_lower <= h_upper, or equal;   h = f + g;   f = sgn(u) sqrt|u|;   u = 0 on outlines
//
// At nodes of B that only an inequality lifts, f >= 0 and its gap >= 0 are complementary. The
// iteration solves with y = f or -gap, while the depth order has that gap fixed at 0.
//
//   letter       in the code
//   u            NonlinearState::u
//   h, g         Ordering::h, g
//   M, L, M c    NonlinearModel::mass, L, load
//   B, m         NonlinearModel::bound, bound_mass
//   eps, b       ShiftMetric
//   y            BoundaryStep; sgn(y) y^2 is stored in u
//
// Starts of the non-linear iteration from an earlier one, on any mesh:
//
//   u_n    <-  u_n + rise between the marks beside n on the outline       on B
//   phi_n  <-  phi_mark M_n / sum of M over the nodes nearest to the mark    in pairs and on B
//
//   letter    in the code
//   phi, M    NonlinearState::load, NonlinearModel::mass
//   rise      NonlinearMark::rise

#include "relief/nonlinear/solve_nonlinear.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "kernel/base/workers.h"
#include "kernel/geometry/nearest_mark.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/poisson_system.h"
#include "relief/nonlinear/nonlinear_iteration.h"
#include "relief/nonlinear/nonlinear_map.h"
#include "relief/nonlinear/nonlinear_model.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Returns the nodes of pairs and of B, ascending.
std::vector<int> marked_nodes(const LayeredMesh& mesh, const NonlinearModel& model) {
  std::vector<int> nodes = model.bound;
  for (const DepthPair& pair : mesh.constraints) {
    nodes.push_back(pair.lower);
    nodes.push_back(pair.upper);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

NonlinearMark mark_at(const LayeredMesh& mesh, int node) {
  NonlinearMark mark;
  mark.part = mesh.node_part[node];
  mark.position = mesh.vertices[mesh.node_vertex[node]];
  return mark;
}

/// Interpolates the rise between the nearest marks on outlines on both sides of `place`. Returns
/// nothing if the part has none.
std::optional<double> rise_at(const std::vector<NonlinearMark>& marks, const NonlinearMark& place) {
  const auto on_outline = [](const NonlinearMark& mark) { return mark.on_outline; };
  const auto beside = marks_beside(marks, place, on_outline);
  if (!beside) return std::nullopt;
  return beside->near->rise + beside->share * (beside->beyond->rise - beside->near->rise);
}

void recall_bound(const LayeredMesh& mesh, const NonlinearModel& model,
                  const std::vector<NonlinearMark>& marks, NonlinearState& state) {
  for (size_t i = 0; i < model.bound.size(); ++i) {
    const int n = model.bound[i];
    const double u = state.u[n] + rise_at(marks, mark_at(mesh, n)).value_or(0);
    state.u[n] = model.sign[n] * u < 0 && model.lifting_gap[i] < 0 ? 0 : u;
  }
}

/// Returns the marks of `state` at the nodes of the pairs and of B. u_start: #N, scene units.
/// O(pairs log pairs).
std::vector<NonlinearMark> remember(const LayeredMesh& mesh, const NonlinearModel& model,
                                    const VectorXd& u_start, const NonlinearState& state) {
  std::vector<NonlinearMark> marks;
  for (const int n : marked_nodes(mesh, model)) {
    NonlinearMark mark = mark_at(mesh, n);
    mark.on_outline = model.inner_index[n] < 0;
    mark.rise = state.u[n] - u_start[n];
    mark.load = state.load[n];
    marks.push_back(mark);
  }
  sort_marks(marks);
  return marks;
}

/// Starts `state`, whose u is that of the start, from marks near its nodes on the same parts: sets
/// u on B, and the loads of the nodes of the pairs and B, among which each mark's load is divided.
/// Nodes of parts without marks keep their values. O(pairs log marks) unless marks are stacked
/// above each other on the canvas.
void recall(const LayeredMesh& mesh, const NonlinearModel& model,
            const std::vector<NonlinearMark>& marks, NonlinearState& state) {
  if (marks.empty()) return;
  recall_bound(mesh, model, marks, state);
  const std::vector<int> nodes = marked_nodes(mesh, model);
  std::vector<const NonlinearMark*> nearest;
  VectorXd shared = VectorXd::Zero(static_cast<Eigen::Index>(marks.size()));
  for (const int n : nodes) {
    nearest.push_back(nearest_mark(marks, mark_at(mesh, n)));
    if (nearest.back() != nullptr) shared[nearest.back() - marks.data()] += model.mass[n];
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const int n = nodes[i];
    state.load[n] = nearest[i]->load * model.mass[n] / shared[nearest[i] - marks.data()];
  }
}

/// Largest number of times that nodes with the wrong sign are fixed.
constexpr int sign_rounds = 3;
/// Largest number of times that pulling gaps are released, and of iterations each time.
constexpr int release_rounds = 3;
constexpr int release_iterations = 40;

bool is_positive(double value) { return value > 0 && std::isfinite(value); }

Status check_options(const NonlinearOptions& options) {
  if (!(options.lambda_bnd >= min_lambda_bnd && options.lambda_bnd <= max_lambda_bnd))
    return Error{ErrorCode::usage, "lambda_bnd must lie between 1e-6 and 1e6", "lambda_bnd"};
  if (!(options.lambda_shift >= min_lambda_shift && options.lambda_shift <= max_lambda_shift))
    return Error{ErrorCode::usage, "lambda_shift must lie between 0.001 and 100", "lambda_shift"};
  if (!is_positive(options.tolerance))
    return Error{ErrorCode::usage, "the tolerance must be positive", "tolerance"};
  if (options.max_iterations < 1)
    return Error{ErrorCode::usage, "there must be at least one iteration", "max_iterations"};
  if (!std::is_sorted(options.snapshots.begin(), options.snapshots.end()))
    return Error{ErrorCode::usage, "the steps must be in ascending order", "snapshots"};
  return check_options(options.ordering);
}

NonlinearState first_state(const NonlinearModel& model, const Inflation& start) {
  NonlinearState state;
  const double area = model.metric.scale * model.metric.scale;
  state.u = model.fixed_u;
  for (const std::vector<int>* nodes : {&model.inner, &model.bound})
    for (const int n : *nodes) state.u[n] = area * start.u[n];
  state.load = VectorXd::Zero(state.u.size());
  return state;
}

VectorXd in_scene_units(const std::vector<double>& values, double factor) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index n = 0; n < result.size(); ++n) result[n] = factor * values[n];
  return result;
}

/// Turns gaps >= 0 into gaps fixed at 0, or back. The matrix is the same for both. `gaps`: children
/// of the gaps, or -1.
void fix_gaps(const std::vector<int>& gaps, bool fixed, DepthSystem& depth) {
  std::vector<bool> is_meant(depth.closed.size(), false);
  for (const int gap : gaps)
    if (gap >= 0) is_meant[gap] = true;
  for (DepthGap& gap : depth.forest.gaps) {
    if (!is_meant[gap.child]) continue;
    gap.equal = fixed;
    depth.qp.fixed[gap.child] = fixed;
    depth.qp.bounded[gap.child] = !fixed;
  }
}

/// The iteration and the systems that it solves with.
class NonlinearSolver {
 public:
  NonlinearSolver(const SurfaceInput& surface, const Inflation& start,
                  const NonlinearOptions& options, const NonlinearMemory& known,
                  OrderingSystem& system, const RunContext& context)
      : surface_(surface),
        known_(known),
        options_(options),
        system_(system),
        context_(context),
        model_(make_joint_model(surface, start, system.metric)),
        is_recalled_(!known.marks.empty()) {
    model_.lambda_bnd = options.lambda_bnd;
    model_.lambda_shift = options.lambda_shift;
    run_.state = first_state(model_, start);
    u_start_ = run_.state.u;
  }

  Status solve(NonlinearSolution& solution) {
    set_pairs(surface_, system_, context_);
    if (context_.cancelled()) return interrupted_error();
    const LayeredMesh& mesh = surface_.mesh;
    system_.depth.closed = gaps_like(mesh, system_.depth.forest, known_.contacts);
    find_lifting_gaps(system_.depth.forest, model_);
    recall(mesh, model_, known_.marks, run_.state);
    if (Status status = iterate_with_gaps_fixed(options_); !status) return status;
    if (run_.report.status == SolveStatus::solved && !is_mixed(model_))
      if (Status status = release_pulling_gaps(); !status) return status;
    for (const auto& [step, u] : std::exchange(run_.kept, {})) {
      NonlinearSnapshot snapshot{step, inflation_of(u), {}};
      const Status status = order(snapshot.inflation, snapshot.ordering);
      if (!status) return status;
      solution.snapshots.push_back(std::move(snapshot));
    }
    solution.inflation = inflation_of(run_.state.u);
    if (Status status = order(solution.inflation, solution.ordering); !status) return status;
    const VectorXd g = in_scene_units(solution.ordering.g, model_.metric.scale);
    run_.report.energy = nonlinear_energy(model_, with_signs(run_.state.u), g);
    solution.report = run_.report;
    if (run_.report.status == SolveStatus::solved)
      solution.memory = {remember(mesh, model_, u_start_, run_.state),
                         contacts_of(mesh, run_.state.h)};
    return Done{};
  }

 private:
  /// Iterates. Obtuse faces can give u the wrong sign; fixes it at 0 there and continues.
  Status iterate(const NonlinearOptions& options) {
    BoundaryStep bound(model_, system_.depth);
    if (Status status = prepare(bound); !status) return status;
    for (int i = 0;; ++i) {
      if (!response_) response_.emplace(model_);
      if (!response_->is_solvable())
        return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
      if (std::exchange(is_recalled_, false)) inflate_recalled();
      const Status status =
          iterate_nonlinear(*response_, system_.depth, bound, options, context_, run_);
      if (!status) return status;
      if (i == sign_rounds || !fix_wrong_signs(run_.state.u, model_)) break;
      response_.reset();
    }
    return Done{};
  }

  /// Iterates with the lifting gaps fixed in the depth order, since y on B contains them, and then
  /// sets its active set from y.
  Status iterate_with_gaps_fixed(const NonlinearOptions& options) {
    fix_gaps(model_.lifting_gap, true, system_.depth);
    const Status status = iterate(options);
    fix_gaps(model_.lifting_gap, false, system_.depth);
    for (size_t i = 0; i < model_.bound.size(); ++i)
      if (model_.lifting_gap[i] >= 0)
        system_.depth.closed[model_.lifting_gap[i]] = towards_lift(run_.state.u, i) >= 0;
    return status;
  }

  /// Where parts press beside B, u can rise cheaply above the height that closes a gap, and the
  /// closed gap pulls. Treats such gaps as ordinary inequalities as long as that lowers the energy.
  Status release_pulling_gaps() {
    NonlinearOptions options = options_;
    options.max_iterations = std::min(options.max_iterations, release_iterations);
    run_.single_attempt = true;
    for (int round = 0; round < release_rounds && !run_.pulling.empty(); ++round) {
      const NonlinearRun before = run_;
      for (int& gap : model_.lifting_gap)
        if (std::count(before.pulling.begin(), before.pulling.end(), gap) > 0) gap = -1;
      run_.pulling.clear();
      double energies[2] = {0, 0};
      if (Status status = find_energy(energies[0]); !status) return status;
      if (Status status = iterate_with_gaps_fixed(options); !status) return status;
      if (Status status = find_energy(energies[1]); !status) return status;
      if (run_.report.status == SolveStatus::solved && energies[1] < energies[0]) continue;
      run_ = before;
      break;
    }
    return Done{};
  }

  /// Computes the energy of u with the best heights for it.
  Status find_energy(double& energy) {
    const double scale = model_.metric.scale;
    const VectorXd u = with_signs(run_.state.u);
    const VectorXd f = u.unaryExpr(&signed_root);
    Ordering ordering;
    const SolveStatus solved =
        solve_heights(system_.depth, model_.metric, f / scale, ordering, context_);
    energy = nonlinear_energy(model_, u, in_scene_units(ordering.h, scale) - f).total();
    return check_solved(solved);
  }

  /// Returns u at node i of B, positive in the direction in which gaps lift f: negative if the gap
  /// is open.
  double towards_lift(const VectorXd& u, size_t i) const {
    const int n = model_.bound[i];
    return model_.sign[n] < 0 ? -u[n] : u[n];
  }

  Status prepare(BoundaryStep& bound) {
    SolveStatus status = SolveStatus::solved;
    run_tasks(2, [&](int task) {
      if (task == 0)
        status = bound.prepare(context_);
      else if (!response_)
        response_.emplace(model_);
    });
    return check_solved(status);
  }

  /// Recalled values are only those of single nodes: sets u on I to the inflation under the
  /// recalled loads.
  void inflate_recalled() {
    VectorXd& u = run_.state.u;
    const VectorXd recalled = u;
    const VectorXd u_bound = with_signs(u)(model_.bound);
    u = response_->inflate(response_->excess(run_.state.load), u_bound);
    for (const int n : model_.bound) u[n] = recalled[n];
  }

  /// Sets u to 0 where it has the wrong sign, which stands for an open gap or comes from obtuse
  /// faces.
  VectorXd with_signs(VectorXd u) const {
    for (Eigen::Index n = 0; n < u.size(); ++n)
      if (model_.sign[n] * u[n] < 0) u[n] = 0;
    for (size_t i = 0; i < model_.bound.size(); ++i)
      if (model_.lifting_gap[i] >= 0 && towards_lift(u, i) < 0) u[model_.bound[i]] = 0;
    return u;
  }

  Inflation inflation_of(const VectorXd& u) const {
    Inflation inflation =
        make_inflation(surface_.discretisation.gradients, with_signs(u), model_.metric.scale);
    raise_bumps(surface_, options_.bumps, inflation);
    return inflation;
  }

  /// Computes the exact depth order for an inflation.
  Status order(const Inflation& inflation, Ordering& ordering) {
    const SolveStatus solved = solve_heights(system_.depth, model_.metric,
                                             inflated_heights(inflation.u), ordering, context_);
    if (Status status = check_solved(solved); !status) return status;
    finish_ordering(surface_, inflation, ordering);
    return Done{};
  }

  const SurfaceInput& surface_;
  const NonlinearMemory& known_;
  const NonlinearOptions& options_;
  OrderingSystem& system_;
  const RunContext& context_;
  NonlinearModel model_;
  bool is_recalled_;  ///< whether u has recalled values that are not inflated yet
  std::optional<InflationResponse> response_;
  VectorXd u_start_;
  NonlinearRun run_;
};

}  // namespace

Result<NonlinearSolution> solve_nonlinear(const SurfaceInput& surface, const Inflation& start,
                                          const NonlinearOptions& options,
                                          const NonlinearMemory& known, OrderingSystem& system,
                                          const RunContext& context) {
  assert(start.u.size() == surface.mesh.node_vertex.size());
  assert(static_cast<int>(surface.scene.parts.size()) == surface.mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  set_metric(surface, options.ordering.epsilon, system, context);
  set_wanted(surface, start, options.ordering, system);
  NonlinearSolver solver(surface, start, options, known, system, context);
  NonlinearSolution solution;
  if (Status status = solver.solve(solution); !status) return status.error();
  context.report("nonlinear", 1);
  return solution;
}

}  // namespace relievo::relief
