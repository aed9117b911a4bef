#include "benchmarks/characters.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "io/svg/read_svg.h"
#include "relief/session/relief_session.h"

namespace relievo::benchmarks {
namespace {

template <class T>
T value_or_exit(Result<T> result, const std::string& name) {
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), to_string(result.error()).c_str());
    std::exit(1);
  }
  return std::move(*result);
}

Scene read_example(const std::string& name) {
  std::ifstream in(std::string(RELIEVO_EXAMPLES) + "/" + name + ".svg", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return value_or_exit(read_svg(text), name).scene;
}

Surface make_surface(const std::string& name, int vertices) {
  const Scene& scene = scene_of(name);
  Surface surface;
  surface.mesh = value_or_exit(relief::layer_parts(scene, options_for(vertices).layers), name);
  surface.discretisation = relief::discretise(surface.mesh);
  relief::PoissonSystem poisson(surface.mesh, surface.discretisation, Refactorisation::complete,
                                {});
  surface.inflation = value_or_exit(relief::inflate({surface.mesh, surface.discretisation, scene},
                                                    relief::InflationOptions(), poisson),
                                    name);
  relief::ReliefSession coarse(relief::ReliefSession::Use::guess);
  if (coarse.update(scene, options_for(vertices / 8))) surface.coarse = coarse.contacts();
  return surface;
}

}  // namespace

const std::vector<Character>& characters() {
  static const std::vector<Character> all = {{"bunny", 19000},   {"elephant", 39000},
                                             {"farmer", 33000},  {"lamb", 30000},
                                             {"unicorn", 22000}, {"wolf", 32000}};
  return all;
}

const Scene& scene_of(const std::string& name) {
  static std::map<std::string, Scene> scenes;
  auto found = scenes.find(name);
  if (found == scenes.end()) found = scenes.emplace(name, read_example(name)).first;
  return found->second;
}

relief::ReliefOptions options_for(int vertices) {
  relief::ReliefOptions options;
  options.layers.vertex_budget = vertices;
  return options;
}

const Surface& surface_of(const std::string& name, int vertices) {
  static std::pair<std::string, int> last;
  static Surface surface;
  if (last != std::pair(name, vertices)) surface = make_surface(name, vertices);
  last = {name, vertices};
  return surface;
}

Program program_of(const Surface& surface) {
  Program program;
  program.metric =
      relief::make_shift_metric(surface.discretisation, relief::OrderingOptions().epsilon);
  program.system = relief::make_depth_system(
      relief::build_depth_forest(surface.mesh.node_part, surface.mesh.constraints), program.metric,
      surface.discretisation.elimination, {}, {});
  relief::solve_heights(program.system, program.metric,
                        relief::inflated_heights(surface.inflation.u), program.ordering, {});
  return program;
}

}  // namespace relievo::benchmarks
