#pragma once

#include <rapidcheck.h>

#include <vector>

#include "relief/inflation/inflation.h"
#include "support/stacked_parts.h"

namespace relievo::testing {

/// A few parts on a small grid with arbitrary heights, leans and pairs: equalities, cycles and
/// diamonds among them.
struct RandomDepth {
  relief::LayeredMesh mesh;
  Scene scene;
  relief::Inflation inflation;
};

inline RandomDepth random_depth() {
  const int columns = *rc::gen::inRange(1, 5);
  const int rows = *rc::gen::inRange(1, 4);
  std::vector<Cover> parts;
  const int part_count = *rc::gen::inRange(2, 6);
  for (int p = 0; p < part_count; ++p) {
    const double left = *rc::gen::inRange(0, columns);
    const double top = *rc::gen::inRange(0, rows);
    const double right = left + *rc::gen::inRange(1, columns + 1);
    const double bottom = top + *rc::gen::inRange(1, rows + 1);
    parts.push_back(in_box({left, top}, {right, bottom}));
  }
  RandomDepth random{stack_parts(grid_mesh(columns, rows, 1), parts), {}, {}};
  random.scene = scene_of(random.mesh);
  for (Part& part : random.scene.parts)
    part.lean = {0.25 * *rc::gen::inRange(-3, 4), 0.25 * *rc::gen::inRange(-3, 4)};
  std::vector<std::vector<int>> at_vertex(random.mesh.vertices.size());
  for (size_t n = 0; n < random.mesh.node_vertex.size(); ++n) {
    random.inflation.u.push_back(0.25 * *rc::gen::inRange(-8, 17));
    at_vertex[random.mesh.node_vertex[n]].push_back(static_cast<int>(n));
  }
  for (const std::vector<int>& nodes : at_vertex) {
    const int pairs =
        nodes.size() < 2 ? 0 : *rc::gen::inRange(0, 2 * static_cast<int>(nodes.size()));
    for (int i = 0; i < pairs; ++i) {
      const int lower = *rc::gen::elementOf(nodes);
      const int upper = *rc::gen::elementOf(nodes);
      const bool equal = *rc::gen::inRange(0, 8) == 0;
      if (lower != upper) random.mesh.constraints.push_back({lower, upper, equal});
    }
  }
  return random;
}

}  // namespace relievo::testing
