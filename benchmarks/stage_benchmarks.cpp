#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <string>

#include "api/solid_of.h"
#include "benchmarks/characters.h"
#include "benchmarks/suites.h"
#include "io/mesh/glb_encode.h"
#include "io/mesh/threemf_encode.h"
#include "kernel/base/workers.h"
#include "relief/session/relief_session.h"
#include "relief/surface/assemble_model.h"
#include "solid/check_print.h"

namespace relievo::benchmarks {
namespace {

using benchmark::State;
using Case = std::function<void(State&, const std::string& name, int vertices)>;

void mesh(State& state, const std::string& name, int vertices) {
  const relief::LayerOptions options = options_for(vertices).layers;
  for (auto _ : state) {
    const auto layers = relief::layer_parts(scene_of(name), options);
    state.counters["vertices"] = static_cast<double>(layers->node_vertex.size());
  }
}

void discretisation(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  for (auto _ : state) benchmark::DoNotOptimize(relief::discretise(surface.mesh));
}

void inflation(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  for (auto _ : state) {
    relief::PoissonSystem poisson(surface.mesh, surface.discretisation, Refactorisation::complete,
                                  {});
    benchmark::DoNotOptimize(
        relief::inflate({surface.mesh, surface.discretisation, scene_of(name)}, {}, poisson));
  }
}

void order_from(State& state, const std::string& name, const Surface& surface,
                const std::vector<relief::DepthContact>& contacts) {
  for (auto _ : state) {
    relief::OrderingSystem system;
    system.contacts = contacts;
    const auto ordering = relief::order_depth(
        {surface.mesh, surface.discretisation, scene_of(name)}, surface.inflation, {}, system);
    const BoundQpReport& report = ordering->report;
    state.counters["iterations"] = report.iterations;
    state.counters["inequalities"] = ordering->inequalities;
    state.counters["active"] = report.active;
    state.counters["kkt"] =
        std::max({report.stationarity, report.primal, report.dual, report.complementarity});
  }
}

void order_cold(State& state, const std::string& name, int vertices) {
  order_from(state, name, surface_of(name, vertices), {});
}

void order_from_coarse(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  order_from(state, name, surface, surface.coarse);
}

/// Times operators, inflation and order: everything but the mesh.
void solve(State& state, const std::string& name, int vertices) {
  const Surface& surface = surface_of(name, vertices);
  const Scene& scene = scene_of(name);
  for (auto _ : state) {
    const relief::Discretisation operators = relief::discretise(surface.mesh);
    relief::OrderingSystem system;
    system.contacts = surface.coarse;
    relief::Inflation inflation;
    run_tasks(2, [&](int task) {
      if (task == 1) return relief::prepare_ordering({surface.mesh, operators, scene}, {}, system);
      relief::PoissonSystem poisson(surface.mesh, operators, Refactorisation::complete, {});
      inflation = *inflate({surface.mesh, operators, scene}, {}, poisson);
    });
    benchmark::DoNotOptimize(
        relief::order_depth({surface.mesh, operators, scene}, inflation, {}, system));
  }
}

void build(State& state, const std::string& name, int vertices) {
  for (auto _ : state)
    benchmark::DoNotOptimize(relief::build_relief(scene_of(name), options_for(vertices)));
}

void model(State& state, const std::string& name, int vertices) {
  const auto relief = relief::build_relief(scene_of(name), options_for(vertices));
  for (auto _ : state) {
    const auto made = relief::assemble_model(
        {relief->layers, relief->inflation, relief->ordering, scene_of(name)}, {});
    benchmark::DoNotOptimize(encode_glb(*made, nullptr, {.size_mm = 100}));
  }
}

/// Times a solid, the check whether it can be printed, and its painted 3MF file.
void hold(State& state, const std::string& name, int vertices, const SolidOptions& kind) {
  relief::ReliefOptions options = options_for(vertices);
  options.hidden = kind.back != BackSide::flat;
  const Scene& scene = scene_of(name);
  const auto relief = relief::build_relief(scene, options);
  for (auto _ : state) {
    const auto solid = solid_of(*relief, scene, {}, kind);
    benchmark::DoNotOptimize(check_print(solid->model, solid->facts.loose, usual_nozzle));
    benchmark::DoNotOptimize(encode_3mf(solid->model, nullptr, {}));
    state.counters["triangles"] = static_cast<double>(solid->model.triangles.size());
  }
}

void solid(State& state, const std::string& name, int vertices) { hold(state, name, vertices, {}); }

SolidOptions as_figure() {
  SolidOptions options;
  options.back = BackSide::mirror;
  return options;
}

void figure(State& state, const std::string& name, int vertices) {
  hold(state, name, vertices, as_figure());
}

/// Times a figure united with the mirrored legs of its far side.
void mirrored(State& state, const std::string& name, int vertices) {
  SolidOptions options = as_figure();
  for (const Part& part : scene_of(name).parts)
    if (part.id.starts_with("near-") && part.id.ends_with("leg")) options.mirror = {part.id};
  hold(state, name, vertices, options);
}

struct Stage {
  const char* name;
  Case run;
};

const Stage stages[] = {
    {"mesh", mesh},
    {"discretise", discretisation},
    {"inflate", inflation},
    {"order_cold", order_cold},
    {"order", order_from_coarse},
    {"solve", solve},
    {"build", build},
    {"model", model},
    {"solid", solid},
    {"figure", figure},
    {"mirrored", mirrored},
};

void add(const std::string& name, int vertices) {
  for (const Stage& stage : stages)
    benchmark::RegisterBenchmark(
        (std::string(stage.name) + "/" + name + "/" + std::to_string(vertices)).c_str(),
        [stage, name, vertices](State& state) { stage.run(state, name, vertices); })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

}  // namespace

void register_stages(const Extent& extent) {
  for (const Character& character : characters()) add(character.name, character.paper_vertices);
  for (int vertices = 5000; vertices <= extent.largest; vertices *= 2) add("wolf", vertices);
  for (const Character& character : characters())
    if (std::string(character.name) != "wolf") add(character.name, 40000);
}

}  // namespace relievo::benchmarks
