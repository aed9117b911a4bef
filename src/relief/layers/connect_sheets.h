#pragma once

#include <string>
#include <vector>

#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"

namespace relievo::relief {

/// A join on the base triangulation.
struct JoinPath {
  int upper = -1;
  int lower = -1;
  int loop = -1;              ///< the upper part's loop that it runs along
  int position = 0;           ///< of the first vertex in that loop
  std::vector<int> vertices;  ///< base vertices, consecutive in the loop (modulo its size)
  std::string name;           ///< for messages, such as `joins[2] ("leg" to "body")`
  Culprit culprit;            ///< the join, for errors
};

/// Cuts the lower sheets open along the joins, back to front, and reconnects what the upper part
/// does not cover to the upper part's nodes; the covered rest stays behind as a flap. Follows
/// the surface that is really there, so a join may run over earlier seams. A part that lies on the
/// lower surface with all of its outline is a bump: its faces take the place of those below, nodes
/// and all, and nothing is cut. Returns warnings; fails with bad_input where a join does not run
/// inside the lower part. O(length of the joins).
Result<std::vector<std::string>> connect_sheets(const std::vector<JoinPath>& joins, int part_count,
                                                SheetMesh& mesh);

}  // namespace relievo::relief
