#pragma once

#include "kernel/geometry/polygon.h"
#include "relief/discretisation/discretisation.h"
#include "relief/hiding/hidden_sheets.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo {

/// The surface that is seen from the front, and what was computed of it.
struct HidingInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
  const Inflation& inflation;
  const Ordering& ordering;
};

/// Brings what is hidden below what is seen, which stays as it is: flaps are inflated and hung up
/// at the edges where they go on from the rest of their sheet, and hidden nodes that come out in
/// front are lowered, node by node and where faces cross between nodes. For models with hidden
/// surfaces only. O(F), and a factorisation of the flaps.
HiddenSheets hide_sheets(const HidingInput& input, const RunContext& context = {});

}  // namespace relievo
