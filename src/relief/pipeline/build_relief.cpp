#include "relief/pipeline/build_relief.h"

#include <chrono>
#include <utility>

namespace relievo {
namespace {

/// Fills a list of wall times. The time of a stage is without the pieces that it reported.
class StageClock {
 public:
  explicit StageClock(std::vector<StageTime>& times) : times_(times) {}

  /// `context` with the pieces' times going to the list.
  RunContext listen(RunContext context) {
    context.timed = [this](const char* piece, double milliseconds) {
      times_.push_back({piece, milliseconds});
      pieces_ += milliseconds;
    };
    return context;
  }

  void finish(const char* stage) {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - last_;
    times_.push_back({stage, elapsed.count() - pieces_});
    last_ = now;
    pieces_ = 0;
  }

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<StageTime>& times_;
  Clock::time_point last_ = Clock::now();
  double pieces_ = 0;
};

Status order(const Scene& scene, const ReliefOptions& options, const RunContext& context,
             Relief& relief) {
  auto ordering = order_depth(relief.layers, relief.inflation, scene, options.ordering, context);
  if (!ordering) return ordering.error();
  relief.ordering = std::move(*ordering);
  return Done{};
}

Status solve_nonlinear(const Scene& scene, const ReliefOptions& options, const RunContext& context,
                       Relief& relief) {
  JointOptions joint = options.joint;
  joint.epsilon = options.ordering.epsilon;
  joint.max_rounds = options.ordering.max_rounds;
  auto solution = solve_jointly(relief.layers, scene, relief.inflation, joint, context);
  if (!solution) return solution.error();
  relief.inflation = std::move(solution->inflation);
  relief.ordering = std::move(solution->ordering);
  relief.joint = std::move(solution->report);
  relief.snapshots = std::move(solution->snapshots);
  return Done{};
}

}  // namespace

Result<Relief> build_relief(const Scene& scene, const ReliefOptions& options,
                            const RunContext& context) {
  if (Status status = validate(scene); !status) return status.error();
  Relief relief;
  std::vector<StageTime> times;
  StageClock clock(times);
  const RunContext timed = clock.listen(context);
  auto layers = layer_parts(scene, options.layers, timed);
  if (!layers) return layers.error();
  relief.layers = std::move(*layers);
  clock.finish("mesh");
  auto inflation = inflate(relief.layers, scene, options.inflation, timed);
  if (!inflation) return inflation.error();
  relief.inflation = std::move(*inflation);
  clock.finish("inflate");
  const bool nonlinear = options.method == Method::nonlinear;
  if (Status status = (nonlinear ? solve_nonlinear : order)(scene, options, timed, relief); !status)
    return status.error();
  clock.finish(nonlinear ? "nonlinear" : "order");
  relief.times = std::move(times);
  return relief;
}

}  // namespace relievo
