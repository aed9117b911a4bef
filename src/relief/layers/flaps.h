#pragma once

#include <vector>

#include "relief/layers/layered_mesh.h"
#include "relief/layers/local_order.h"
#include "relief/layers/sheet_mesh.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Finds the faces behind parts that grow out of their surface, #F: from the covered side of each
/// join as far as the upper part covers the surface. They are `loose`, or `kept` if `loose` is
/// false, if d changes its sign on the surface, or if the rest of the surface would have no
/// outline. `role` is that of each node. O((F + faces of the flaps) * height of the stacks).
std::vector<Flap> find_flaps(const SheetMesh& mesh, const std::vector<NodeRole>& role,
                             const LocalOrder& order, const Scene& scene, bool loose);

}  // namespace relievo::relief
