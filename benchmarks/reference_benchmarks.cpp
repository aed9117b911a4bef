#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#include <string>

#include "benchmarks/characters.h"
#include "benchmarks/references/cholmod_factor.h"
#include "benchmarks/references/interior_point.h"
#include "benchmarks/references/lagrange_active_set.h"
#include "benchmarks/suites.h"
#include "relief/session/relief_session.h"

namespace relievo::benchmarks {
namespace {

using benchmark::State;

constexpr int largest_for_slow_ones = 40000;

std::string name_of(const char* what, const std::string& name, int vertices) {
  return std::string(what) + "/" + name + "/" + std::to_string(vertices);
}

void own_factor(State& state, const std::string& name, int vertices) {
  Program program = program_of(surface_of(name, vertices));
  for (auto _ : state)
    if (!program.system.factor.factorise(program.system.qp.K)) state.SkipWithError("not definite");
  state.counters["entries"] = static_cast<double>(program.system.factor.factor_entries());
}

void cholmod(State& state, const std::string& name, int vertices, bool simplicial) {
  CholmodFactor factor(program_of(surface_of(name, vertices)).system.qp.K, simplicial);
  for (auto _ : state)
    if (!factor.factorise()) state.SkipWithError("not definite");
}

void cholmod_simplicial(State& state, const std::string& name, int vertices) {
  cholmod(state, name, vertices, true);
}

void cholmod_choice(State& state, const std::string& name, int vertices) {
  cholmod(state, name, vertices, false);
}

void eigen(State& state, const std::string& name, int vertices) {
  const SparseMatrix K = program_of(surface_of(name, vertices)).system.qp.K;
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower> factor;
  factor.analyzePattern(K);
  for (auto _ : state) {
    factor.factorize(K);
    if (factor.info() != Eigen::Success) state.SkipWithError("not definite");
  }
}

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>();
}

void multipliers(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  const Program program = program_of(surface);
  const Eigen::VectorXd f = program.metric.scale * inflated_heights(surface.inflation.u);
  Eigen::VectorXd h(f.size());
  for (Eigen::Index n = 0; n < h.size(); ++n) h[n] = program.metric.scale * program.ordering.h[n];
  for (auto _ : state) {
    const ReferenceSolution solution =
        solve_with_multipliers(program.metric.A, f, surface.mesh.constraints);
    if (!solution.solved) state.SkipWithError("not solved");
    state.counters["iterations"] = solution.iterations;
    state.counters["difference"] = difference(solution.x, h);
  }
}

void interior_point(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  Program program = program_of(surface);
  BoundQpOptions cold;
  const BoundQpSolution exact = solve_bound_qp(program.system.qp, program.system.factor, cold);
  for (auto _ : state) {
    const ReferenceSolution solution =
        solve_by_interior_point(program.system.qp, surface.discretisation.elimination);
    if (!solution.solved) state.SkipWithError("not solved");
    state.counters["iterations"] = solution.iterations;
    state.counters["difference"] = difference(solution.x, exact.z);
  }
}

void add_size(const std::string& name, int vertices) {
  const auto add = [&](const char* what, auto run) {
    return benchmark::RegisterBenchmark(
               name_of(what, name, vertices).c_str(),
               [run, name, vertices](State& state) { run(state, name, vertices); })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  };
  add("factor", own_factor);
  add("cholmod_simplicial", cholmod_simplicial);
  add("cholmod_choice", cholmod_choice);
  add("eigen", eigen);
  if (vertices > largest_for_slow_ones) return;
  add("interior_point", interior_point);
  add("multipliers", multipliers)->Iterations(1);
}

}  // namespace

void register_references(const Extent& extent) {
  for (int vertices = 5000; vertices <= extent.largest; vertices *= 2) add_size("wolf", vertices);
  for (const Character& character : characters())
    if (std::string(character.name) != "wolf") add_size(character.name, 40000);
}

}  // namespace relievo::benchmarks
