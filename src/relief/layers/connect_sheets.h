#pragma once

#include <string>
#include <vector>

#include "relief/layers/sheets.h"
#include "relievo/result.h"

namespace relievo {

/// A join on the base triangulation.
struct JoinPath {
  int upper = -1;
  int lower = -1;
  int loop = -1;              ///< the upper part's loop that it runs along
  int position = 0;           ///< of the first vertex in that loop
  std::vector<int> vertices;  ///< base vertices, consecutive in the loop (modulo its size)
  std::string name;           ///< for messages, such as `joins[2] ("leg" to "body")`
};

/// A join as it was made.
struct Seam {
  int upper = -1;
  int lower = -1;
  int loop = -1;
  int position = 0;               ///< of its first vertex in the loop
  int edges = 0;                  ///< it has edges + 1 vertices, ends included
  bool first_end_inside = false;  ///< the end was merged into the inside of the lower surface
  bool last_end_inside = false;
  bool bump = false;         ///< the upper part lies on the lower surface with all of its outline
  std::vector<int> covered;  ///< faces of the lower surface beside it, under the upper part
};

struct Connection {
  std::vector<Seam> seams;   ///< one per path that could be made
  std::vector<int> surface;  ///< per part: the lowest part it is joined with, itself if none
  std::vector<std::string> warnings;
};

/// Cuts the lower sheets open along the joins, back to front, and reconnects what the upper part
/// does not cover to the upper part's nodes; the covered rest stays behind as a flap. Follows
/// the surface that is really there, so a join may run over earlier seams. A part that lies on the
/// lower surface with all of its outline is a bump: its faces take the place of those below, nodes
/// and all, and nothing is cut. Fails with bad_input
/// where a join does not run inside the lower part. O(length of the joins).
Result<Connection> connect_sheets(const BaseMesh& base, const std::vector<JoinPath>& joins,
                                  int part_count, Sheets& sheets);

}  // namespace relievo
