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

/// A drawing of the examples and the number of vertices of its counterpart in the paper.
struct Character {
  const char* name;
  int paper_vertices;
};

const std::vector<Character>& characters();

/// Returns the scene of examples/<name>.svg. Ends the program where it cannot be read.
const Scene& scene_of(const std::string& name);

relief::ReliefOptions options_for(int vertices);

/// All stages before the order.
struct Surface {
  relief::LayeredMesh mesh;
  relief::Discretisation discretisation;
  relief::Inflation inflation;
  std::vector<relief::DepthContact> coarse;  ///< contacts on a mesh with an eighth of the vertices
};

/// Returns these stages of a drawing, computed once for consecutive calls with the same arguments.
const Surface& surface_of(const std::string& name, int vertices);

/// The quadratic program of the first round, its metric and its solution without an initial guess.
struct Program {
  relief::ShiftMetric metric;
  relief::DepthSystem system;
  relief::Ordering ordering;
};

Program program_of(const Surface& surface);

}  // namespace relievo::benchmarks
