#pragma once

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/model.h"
#include "relievo/result.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::research {

/// The parts on a mesh with the intermediate results of the stages.
struct Solution {
  relief::LayeredMesh mesh;
  relief::Discretisation discretisation;
  relief::Inflation inflation;
  relief::Ordering ordering;
};

/// Inflates the parts of a mesh [P eq 7, 8], heights 0.
Result<Solution> inflate_parts(relief::LayeredMesh mesh, const Scene& scene,
                               const RunContext& context);

/// Puts the inflated parts in order [P eq 10-13].
Status order_parts(Solution& solution, const Scene& scene, const RunContext& context);

/// Replaces the heights g + sgn(u) sqrt|u| by ones that are linear on faces, whose slope at
/// outlines is finite. `h` is #N, px.
void make_linear(const std::vector<double>& h, Solution& solution);

/// Assembles whole parts, with hidden ones below the visible surface.
Result<Model> model_of(const Solution& solution, const Scene& scene, const RunContext& context);

}  // namespace relievo::research
