#pragma once

#include <string>
#include <vector>

#include "relief/layers/sheet_mesh.h"
#include "relievo/result.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Makes the joins of the scene, of which `runs` are the places on the mesh, and fills seams,
/// surface and passed. In the order of their upper parts, each cuts the lower sheet open along the
/// join and reconnects what the upper part does not cover to the upper part's nodes; the covered
/// rest stays behind as a flap. A join follows the surface that earlier joins have made and so may
/// run over their seams. If the upper part lies on the lower surface with all of its outline it is
/// a bump: its faces replace those below and take over their nodes, and nothing is cut. Returns
/// warnings. Fails with bad_input naming the join if it has collapsed, does not run inside the
/// lower part, or would make three surfaces meet. O(F + length of the joins).
Result<std::vector<std::string>> connect_sheets(const Scene& scene,
                                                const std::vector<LoopRun>& runs, SheetMesh& mesh);

}  // namespace relievo::relief
