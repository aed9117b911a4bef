#pragma once

#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/depth_system.h"
#include "relief/session/build_relief.h"
#include "relievo/scene.h"

namespace relievo::benchmarks {

/// A drawing of the examples and the number of vertices that the paper has for its likeness.
struct Character {
  const char* name;
  int paper_vertices;
};

const std::vector<Character>& characters();

/// The scene of examples/<name>.svg; ends the program where it cannot be read.
const Scene& scene_of(const std::string& name);

relief::ReliefOptions options_for(int vertices);

/// Everything up to the order, computed once for each name and number of vertices.
struct Surface {
  relief::LayeredMesh mesh;
  relief::Discretisation discretisation;
  relief::Inflation inflation;
  std::vector<relief::DepthContact> coarse;  ///< contacts on a mesh with an eighth of the vertices
};

const Surface& surface_of(const std::string& name, int vertices);

/// The quadratic program of the first round, solved from nothing, and its metric.
struct Program {
  relief::ShiftMetric metric;
  relief::DepthSystem system;
  relief::Ordering ordering;
};

Program program_of(const Surface& surface);

}  // namespace relievo::benchmarks
