#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

#include "benchmarks/characters.h"
#include "benchmarks/suites.h"
#include "kernel/base/workers.h"
#include "relief/session/relief_session.h"
#include "support/augmented_lagrangian.h"
#include "support/lbfgs.h"

namespace relievo::benchmarks {
namespace {

using benchmark::State;
using Eigen::VectorXd;

constexpr int largest_for_descent = 2000;
/// The descent stops where its energy exceeds that of the solution by at most this share.
constexpr double descent_accuracy = 1e-3;
constexpr int descent_rounds = 40;
constexpr int descent_steps = 3000;
constexpr double penalty = 30;

/// Both methods take turns, so that other work on the machine slows both equally.
constexpr int turns = 11;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_ms() {
  using std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

/// The least times of repeated runs.
struct LeastTimes {
  double processor = std::numeric_limits<double>::infinity();
  double wall = std::numeric_limits<double>::infinity();

  void add(const std::function<void()>& run) {
    const double processor_start = processor_ms();
    const double wall_start = wall_ms();
    run();
    processor = std::min(processor, processor_ms() - processor_start);
    wall = std::min(wall, wall_ms() - wall_start);
  }
};

/// The initial guess, from a mesh with an eighth of the vertices.
relief::NonlinearMemory coarse_memory(const std::string& name, int vertices,
                                      const relief::NonlinearOptions& options) {
  relief::ReliefOptions coarse = options_for(vertices / 8);
  coarse.method = Method::nonlinear;
  coarse.nonlinear = options;
  relief::ReliefSession session(relief::ReliefSession::Use::guess);
  return session.update(scene_of(name), coarse) ? session.nonlinear_memory()
                                                : relief::NonlinearMemory();
}

/// Computes the inflation and, on another thread, the matrix of the depth order.
relief::Inflation inflation_of(const relief::SurfaceInput& surface,
                               relief::OrderingSystem& system) {
  relief::Inflation inflation;
  run_tasks(2, [&](int task) {
    if (task == 1) return relief::prepare_ordering(surface, {}, system);
    relief::PoissonSystem poisson(surface.mesh, surface.discretisation, Refactorisation::complete,
                                  {});
    inflation = *inflate({surface.mesh, surface.discretisation, surface.scene},
                         relief::InflationOptions(), poisson);
  });
  return inflation;
}

/// Times operators, inflation and order from the coarse guess.
void approximate(const std::string& name, const Surface& surface) {
  const Scene& scene = scene_of(name);
  const relief::Discretisation operators = relief::discretise(surface.mesh);
  relief::OrderingSystem system;
  system.contacts = surface.coarse;
  const relief::Inflation inflation = inflation_of({surface.mesh, operators, scene}, system);
  benchmark::DoNotOptimize(
      relief::order_depth({surface.mesh, operators, scene}, inflation, {}, system));
}

/// Times the same by the non-linear method.
Result<relief::NonlinearSolution> solve(const std::string& name, const Surface& surface,
                                        const relief::NonlinearOptions& options,
                                        const relief::NonlinearMemory& known) {
  const Scene& scene = scene_of(name);
  const relief::Discretisation operators = relief::discretise(surface.mesh);
  relief::OrderingSystem system;
  const relief::Inflation inflation = inflation_of({surface.mesh, operators, scene}, system);
  return relief::solve_nonlinear({surface.mesh, operators, scene}, inflation, options, known,
                                 system);
}

void nonlinear(State& state, const std::string& name, int vertices, double lambda_bnd) {
  const Surface& surface = surface_of(name, vertices);
  relief::NonlinearOptions options;
  options.lambda_bnd = lambda_bnd;
  options.ordering = relief::OrderingOptions();
  const relief::NonlinearMemory known = coarse_memory(name, vertices, options);
  LeastTimes other;
  LeastTimes own;
  for (auto _ : state) {
    for (int turn = 0; turn < turns; ++turn) {
      other.add([&] { approximate(name, surface); });
      own.add([&] {
        const auto solution = solve(name, surface, options, known);
        if (!solution || solution->report.status != SolveStatus::solved)
          state.SkipWithError("not solved");
        else
          state.counters["steps"] = static_cast<double>(solution->report.steps.size());
      });
    }
    state.counters["processor_ms"] = own.processor;
    state.counters["wall_ms"] = own.wall;
    state.counters["ratio"] = own.processor / other.processor;
    state.counters["wall_ratio"] = own.wall / other.wall;
  }
}

/// Times the paper's method: L-BFGS on the augmented Lagrangian, until its energy is near enough.
void descent(State& state, const std::string& name, int vertices, double lambda_bnd) {
  const Surface& surface = surface_of(name, vertices);
  relief::NonlinearOptions options;
  options.lambda_bnd = lambda_bnd;
  const double start = processor_ms();
  const auto ours = solve(name, surface, options, {});
  const double own = processor_ms() - start;
  if (!ours) return state.SkipWithError("not solved");
  const testing::NonlinearProgram program =
      testing::make_nonlinear_program(surface.mesh, scene_of(name), options, ours->inflation);
  relief::OrderingSystem system;
  const relief::Ordering ordering = *order_depth(
      {surface.mesh, surface.discretisation, scene_of(name)}, surface.inflation, {}, system);
  for (auto _ : state) {
    const double begin = processor_ms();
    VectorXd x =
        testing::descent_start(program, testing::point_of(program, surface.inflation, ordering));
    testing::AugmentedLagrangian lagrangian(program, penalty);
    double error = 1;
    for (int round = 0; round < descent_rounds && error > descent_accuracy; ++round) {
      x = testing::minimise_by_lbfgs(lagrangian, x, descent_steps);
      lagrangian.update(x);
      const double energy = testing::energy(program, lagrangian.point(x));
      error = std::abs(energy / ours->report.energy.total() - 1);
    }
    state.counters["ratio"] = (processor_ms() - begin) / own;
    state.counters["error"] = error;
    state.counters["violation"] = testing::violation(program, lagrangian.point(x));
  }
}

template <class Run>
void add(const char* what, Run run, const std::string& name, int vertices, double lambda_bnd) {
  const std::string title = std::string(what) + (lambda_bnd > 1 ? "_100/" : "_0.01/") + name + "/" +
                            std::to_string(vertices);
  benchmark::RegisterBenchmark(title.c_str(),
                               [=](State& state) { run(state, name, vertices, lambda_bnd); })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Iterations(1);
}

}  // namespace

void register_joint(const Extent& extent) {
  for (const double lambda_bnd : {100.0, 0.01}) {
    for (const Character& character : characters())
      add("nonlinear", nonlinear, character.name, 40000, lambda_bnd);
    if (extent.largest >= 160000) add("nonlinear", nonlinear, "wolf", 160000, lambda_bnd);
  }
  for (int vertices = 500; vertices <= largest_for_descent; vertices *= 2)
    add("descent", descent, "wolf", vertices, 100);
}

}  // namespace relievo::benchmarks
