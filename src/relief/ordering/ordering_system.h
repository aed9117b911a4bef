#pragma once

#include <optional>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/cap_rise.h"
#include "relief/ordering/depth_contacts.h"
#include "relief/ordering/depth_problem.h"
#include "relief/ordering/shift_metric.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// The joined surface before it is inflated.
struct SurfaceInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
};

/// What is wanted of shifts besides leans. The paper has neither.
struct WantedShifts {
  bool straight_limbs = true;  ///< limbs keep the height of their roots (limb_rise)
  bool close_caps = true;      ///< caps and spots keep to what they lie on (cap_rise, spot_rise)
};

/// What the ordering of one surface leaves behind for the next one on it.
struct OrderingSystem {
  double epsilon = 0;  ///< that of the metric; 0: there is none yet
  ShiftMetric metric;
  std::optional<Caps> caps;                     ///< with that metric, once they were asked for
  std::optional<std::vector<DepthPair>> pairs;  ///< that `system` is for now, if there is one
  DepthSystem system;
  /// Where a first solve begins: heights on this mesh, or else contacts on another, or else as the
  /// options say.
  std::vector<double> h;
  std::vector<DepthContact> contacts;
};

/// Brings the metric but for its leans up to date; where it changes, the system is for no pairs any
/// more. O(N + F) where there is anything to do.
void set_surface(const SurfaceInput& surface, double epsilon, OrderingSystem& system,
                 const RunContext& context);

/// Brings up to date what the metric says of leans, limbs, caps and spots. Precondition: the
/// surface was set. As lean_term and the rises, and find_caps where other parts are tied.
void set_leans(const SurfaceInput& surface, const Inflation& inflation, const WantedShifts& wanted,
               OrderingSystem& system);

/// Makes the system one for the mesh's pairs; anew where its pattern cannot serve, which takes
/// make_depth_system. For none if `context` is cancelled.
void set_pairs(const SurfaceInput& surface, OrderingSystem& system, const RunContext& context);

/// Makes a system one for `pairs` that link no nodes but those which it was built to link: matrix
/// and factor keep their pattern, and what of the factor stays the same need not be computed again.
/// False, and nothing changes, where other nodes are linked. `metric` is that of the system. Costs
/// as making a system does, but for its analysis.
bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system);

}  // namespace relievo::relief
