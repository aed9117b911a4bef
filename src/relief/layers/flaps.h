#pragma once

#include <vector>

#include "relief/layers/boundaries.h"
#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// What lies under parts that grow out of it, #F: from the covered side of each join as far as the
/// upper part covers the surface, in front of it. Kept where `loose` is false,
/// where d changes its sign on that surface, and where what would be left of it has no outline. O(F
/// + faces of the flaps).
std::vector<Flap> find_flaps(const SheetMesh& mesh, const Boundaries& boundaries,
                             const LocalOrder& order, const Scene& scene, bool loose);

}  // namespace relievo::relief
