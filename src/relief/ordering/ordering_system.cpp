#include "relief/ordering/ordering_system.h"

#include <utility>

#include "kernel/base/piece_timer.h"
#include "relief/ordering/lean_term.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/pair_selection.h"

namespace relievo {

void set_surface(const SurfaceInput& surface, double epsilon, OrderingSystem& system,
                 const RunContext& context) {
  if (system.epsilon != epsilon) {
    const PieceTimer assembling(context, "assemble");
    system.pairs.reset();
    system.metric = make_shift_metric(surface.discretisation, epsilon);
    system.epsilon = epsilon;
  }
}

void set_leans(const SurfaceInput& surface, const Inflation& inflation, bool straight_limbs,
               OrderingSystem& system) {
  ShiftMetric& metric = system.metric;
  metric.lean = lean_term(surface.mesh, surface.scene, metric.scale, system.epsilon);
  if (straight_limbs) add_wanted(limb_rise(surface, inflation), metric);
}

void set_pairs(const SurfaceInput& surface, OrderingSystem& system, const RunContext& context) {
  const std::vector<DepthPair>& pairs = surface.mesh.constraints;
  const std::vector<int>& node_part = surface.mesh.node_part;
  const bool serves =
      system.pairs &&
      (*system.pairs == pairs || select_pairs(node_part, pairs, system.metric, system.system));
  if (!serves) {
    PieceTimer sorting(context, "assemble");
    DepthProblem problem = make_depth_problem(node_part, pairs);
    sorting.stop();
    system.system =
        make_depth_system(std::move(problem), system.metric, surface.discretisation.elimination,
                          std::move(system.system.factor), context);
  }
  system.pairs = pairs;
  if (context.cancelled()) system.pairs.reset();  // it may be half made
}

}  // namespace relievo
