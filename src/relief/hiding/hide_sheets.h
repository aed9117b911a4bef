#pragma once

#include <array>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/operators/gradient.h"
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

/// The flaps of a mesh.
struct Flaps {
  std::vector<Point2> positions;          ///< #N, px
  std::vector<std::array<int, 3>> faces;  ///< of flaps, nodes of the mesh
  std::vector<double> density;            ///< of the source of the inflation, per face
  std::vector<int> nodes;                 ///< inside flaps, ascending
  std::vector<int> place;                 ///< #N, in `nodes`, or -1
  GradientStencils gradients;             ///< on the flaps alone, 1 / px
};

/// Empty where the mesh has none. O(N + faces).
Flaps collect_flaps(const HidingInput& input);

/// Gives the nodes inside flaps u and g: the Poisson problem of their part and the smoothest shift
/// that go on from the nodes at their edges, both free along the cut at the join. One factorisation
/// each of the flaps' nodes.
void fill_flaps(const HidingInput& input, const Flaps& flaps, HiddenSheets& sheets,
                const RunContext& context);

}  // namespace relievo
