#include "relief/nonlinear/nonlinear_iteration.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "kernel/solvers/anderson.h"
#include "relief/ordering/order_depth.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// The accelerator forgets its past when the residual has grown by so much.
constexpr double growth_limit = 100;
/// The same where u may have either sign.
constexpr double mixed_growth_limit = 3;

/// In the order in which they are tried where u may have either sign somewhere.
constexpr Softness softnesses[] = {
    {0.1, 0.01, 0.05}, {0.1, 0.01, 0.1}, {0.3, 0.3, 0.2}, {0.3, 3, 0.2}};

/// The same where it has one sign on every surface.
constexpr Softness pure_softnesses[] = {{1, 0.01}, {1, 1}};

std::span<const Softness> softnesses_of(const NonlinearModel& model) {
  if (is_mixed(model)) return softnesses;
  return pure_softnesses;
}

double relative_change(const VectorXd& x, const VectorXd& F_x, const VectorXd& u) {
  if (x.size() == 0) return 0;
  const double size = std::max(u.lpNorm<Eigen::Infinity>(), std::numeric_limits<double>::min());
  return (F_x - x).lpNorm<Eigen::Infinity>() / size;
}

bool is_kept(size_t step, const NonlinearOptions& options) {
  return std::binary_search(options.snapshots.begin(), options.snapshots.end(),
                            static_cast<int>(step));
}

void record(NonlinearStep step, const VectorXd& u, const NonlinearOptions& options,
            NonlinearRun& run) {
  NonlinearReport& report = run.report;
  report.steps.push_back(step);
  report.residual = step.residual;
  if (is_kept(report.steps.size(), options))
    run.kept.push_back({static_cast<int>(report.steps.size()), u});
}

Status iterate(NonlinearMap& map, double growth, const NonlinearOptions& options,
               const RunContext& context, NonlinearRun& run) {
  NonlinearState& state = run.state;
  AndersonMixer mixer(options.anderson_depth);
  double least = std::numeric_limits<double>::infinity();
  Stopwatch watch;
  if (!map.prepare(context)) return interrupted_error();
  for (int i = 0; i < options.max_iterations; ++i) {
    context.report("nonlinear", static_cast<double>(i) / options.max_iterations);
    const VectorXd x = map.pack(state);
    NonlinearState next = state;
    NonlinearStep step;
    const SolveStatus status = map.apply(next, step, context);
    if (status == SolveStatus::not_positive_definite) break;  // spoiled by rounding
    if (Status solved = check_solved(status); !solved) return solved;
    const VectorXd F_x = map.pack(next);
    step.residual = relative_change(x, F_x, next.u);
    step.milliseconds = watch.lap();
    record(step, next.u, options, run);
    context.measure("energy", step.energy.total());
    if (step.residual <= options.tolerance) {
      map.find_heights(next);
      state = std::move(next);
      run.report.status = NonlinearStatus::solved;
      run.pulled = map.pulled();
      return Done{};
    }
    if (step.residual > growth * least) {
      mixer.restart();
      least = step.residual;
    }
    least = std::min(least, step.residual);
    state = std::move(next);
    map.unpack(mixer.next(F_x, F_x - x), state);
  }
  run.report.status = NonlinearStatus::iteration_limit;
  return Done{};
}

}  // namespace

Status iterate_nonlinear(const NonlinearSystems& systems, const NonlinearOptions& options,
                         const RunContext& context, NonlinearRun& run) {
  const NonlinearModel& model = systems.inflation.model();
  const double growth = is_mixed(model) ? mixed_growth_limit : growth_limit;
  const NonlinearState start = run.state;
  const std::vector<uint8_t> closed = systems.order.closed;
  for (const Softness& softness : softnesses_of(model)) {
    run.state = start;
    systems.order.closed = closed;
    NonlinearMap map(systems, softness);
    if (Status status = iterate(map, growth, options, context, run); !status) return status;
    if (run.report.status == NonlinearStatus::solved) return Done{};
    if (run.once) break;
  }
  run.state = start;
  systems.order.closed = closed;
  return Done{};
}

}  // namespace relievo
