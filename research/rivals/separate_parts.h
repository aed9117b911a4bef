#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"

namespace relievo::research {

/// What becomes of the run of the upper outline along which a join was.
enum class Roots {
  closed,  ///< as all of the outline: u = 0, above the lower part
  open,    ///< natural boundary but for its ends, at the height of the lower part
};

/// A joined mesh with every part on nodes of its own again: same triangles, same stacks.
struct SeparateParts {
  relief::LayeredMesh mesh;
  std::vector<int> joined_node;    ///< #N of `mesh`: the node of the joined mesh that it was, the
                                   ///< frontmost where there were several
  std::vector<int> separate_node;  ///< #N of the joined mesh: the node of its frontmost part
};

/// Takes joins and bumps apart. Depth pairs of the joined mesh hold between the same parts as
/// before, those of joins are added. Without creases, ramps and flaps. Near-linear.
SeparateParts separate_parts(const relief::LayeredMesh& joined, Roots roots);

}  // namespace relievo::research
