#pragma once

#include <array>
#include <vector>

#include "kernel/operators/gradient.h"
#include "relief/hiding/hide_sheets.h"
#include "relievo/run_context.h"

namespace relievo {

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
