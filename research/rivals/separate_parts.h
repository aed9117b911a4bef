#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::research {

/// The boundary condition of the upper outline along a former join.
enum class Roots {
  closed,  ///< that of the rest of the outline: u = 0, above the lower part
  open,    ///< natural, except at its ends, at the height of the lower part
};

/// A joined mesh after every part has got nodes of its own. Triangles and stacks stay.
struct SeparateParts {
  relief::LayeredMesh mesh;
  std::vector<int> joined_node;    ///< #N of `mesh`: the corresponding node of the joined mesh, the
                                   ///< frontmost if there are several
  std::vector<int> separate_node;  ///< #N of the joined mesh: the node of its frontmost part
};

/// Separates parts at joins and bumps. Keeps the depth pairs of the joined mesh, and adds those of
/// joins. Drops creases, ramps and flaps. Near-linear.
SeparateParts separate_parts(const relief::LayeredMesh& joined, Roots roots);

}  // namespace relievo::research
