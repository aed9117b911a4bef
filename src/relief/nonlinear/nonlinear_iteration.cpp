// The fixed-point iteration x = F(x) of the non-linear method with Anderson mixing (Walker and Ni
// 2011, type II): with r_k = F(x_k) - x_k, the differences dF_j = F(x_{j+1}) - F(x_j) and
// dr_j = r_{j+1} - r_j of the last steps,
//
//   x_{k+1} = F(x_k) - sum w_j dF_j,    w minimising |r_k - sum w_j dr_j|
//
// It ends when |r_k| <= tolerance max|u| in the maximum norm.
//
//   letter      in the code
//   F           NonlinearMap::apply, between unpack and pack
//   dF, dr      AndersonMixer::image_steps_, residual_steps_
//   w           weights in AndersonMixer::next

#include "relief/nonlinear/nonlinear_iteration.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "relief/ordering/order_depth.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Number of earlier steps that Anderson mixing combines.
constexpr size_t anderson_depth = 16;

/// Accelerates a fixed-point iteration x = F(x) by Anderson's method.
class AndersonMixer {
 public:
  /// Returns the point to try after x. `residual`: F(x) - x. O(#x depth^2).
  VectorXd next(const VectorXd& F_x, const VectorXd& residual);

  /// Forgets all earlier points.
  void restart();

 private:
  void remember(const VectorXd& F_x, const VectorXd& residual);

  VectorXd last_image_;
  VectorXd last_residual_;
  std::vector<VectorXd> image_steps_;
  std::vector<VectorXd> residual_steps_;
};

VectorXd AndersonMixer::next(const VectorXd& F_x, const VectorXd& residual) {
  remember(F_x, residual);
  if (image_steps_.empty()) return F_x;
  const auto columns = static_cast<Eigen::Index>(image_steps_.size());
  Eigen::MatrixXd R(residual.size(), columns);
  for (Eigen::Index k = 0; k < columns; ++k) R.col(k) = residual_steps_[k];
  const VectorXd weights = R.colPivHouseholderQr().solve(residual);
  VectorXd mixed = F_x;
  for (Eigen::Index k = 0; k < columns; ++k) mixed -= weights[k] * image_steps_[k];
  return mixed;
}

void AndersonMixer::remember(const VectorXd& F_x, const VectorXd& residual) {
  if (last_image_.size() == F_x.size()) {
    image_steps_.push_back(F_x - last_image_);
    residual_steps_.push_back(residual - last_residual_);
    if (image_steps_.size() > anderson_depth) {
      image_steps_.erase(image_steps_.begin());
      residual_steps_.erase(residual_steps_.begin());
    }
  }
  last_image_ = F_x;
  last_residual_ = residual;
}

void AndersonMixer::restart() {
  image_steps_.clear();
  residual_steps_.clear();
  last_image_.resize(0);
  last_residual_.resize(0);
}

/// The mixer restarts if the residual has grown by this factor.
constexpr double growth_limit = 10;
/// The same if u may have either sign somewhere.
constexpr double mixed_growth_limit = 3;

/// Tried in this order if u may have either sign somewhere.
constexpr StepControl mixed_controls[] = {
    {0.1, 0.01, 0.05}, {0.1, 0.01, 0.1}, {0.3, 0.3, 0.2}, {0.3, 3, 0.2}};

/// Tried in this order if u has one sign on every surface.
constexpr StepControl pure_controls[] = {{1, 0.01}, {1, 1}};

std::span<const StepControl> step_controls(const NonlinearModel& model) {
  if (is_mixed(model)) return mixed_controls;
  return pure_controls;
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
  if (is_kept(report.steps.size(), options)) run.kept[static_cast<int>(report.steps.size())] = u;
}

Status iterate(NonlinearMap& map, double growth, const NonlinearOptions& options,
               const RunContext& context, NonlinearRun& run) {
  NonlinearState& state = run.state;
  AndersonMixer mixer;
  double least = std::numeric_limits<double>::infinity();
  Stopwatch watch;
  if (!map.prepare(context)) return interrupted_error();
  for (int i = 0; i < options.max_iterations; ++i) {
    context.report("nonlinear", static_cast<double>(i) / options.max_iterations);
    const VectorXd x = map.pack(state);
    NonlinearState next = state;
    NonlinearStep step;
    const SolveStatus status = map.apply(next, step, context);
    if (status == SolveStatus::not_positive_definite) break;  // by rounding
    if (Status solved = check_solved(status); !solved) return solved;
    const VectorXd F_x = map.pack(next);
    step.residual = relative_change(x, F_x, next.u);
    step.milliseconds = watch.lap();
    record(step, next.u, options, run);
    context.measure("energy", step.energy.total());
    if (step.residual <= options.tolerance) {
      map.find_heights(next);
      state = std::move(next);
      run.report.status = SolveStatus::solved;
      run.pulling = map.pulling();
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
  run.report.status = SolveStatus::iteration_limit;
  return Done{};
}

}  // namespace

Status iterate_nonlinear(const InflationResponse& response, DepthSystem& depth, BoundaryStep& bound,
                         const NonlinearOptions& options, const RunContext& context,
                         NonlinearRun& run) {
  const NonlinearModel& model = response.model();
  const double growth = is_mixed(model) ? mixed_growth_limit : growth_limit;
  const NonlinearState start = run.state;
  const std::vector<uint8_t> closed = depth.closed;
  for (const StepControl& control : step_controls(model)) {
    run.state = start;
    depth.closed = closed;
    NonlinearMap map(response, depth, bound, control);
    if (Status status = iterate(map, growth, options, context, run); !status) return status;
    if (run.report.status == SolveStatus::solved) return Done{};
    if (run.single_attempt) break;
  }
  run.state = start;
  depth.closed = closed;
  return Done{};
}

}  // namespace relievo::relief
