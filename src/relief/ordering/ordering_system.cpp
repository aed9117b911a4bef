#include "relief/ordering/ordering_system.h"

#include <utility>

#include "kernel/base/stopwatch.h"
#include "relief/ordering/cap_rise.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {
namespace {

/// Whether nodes of one group are so in `wider` too.
bool is_within(const std::vector<int>& group, const std::vector<int>& wider) {
  for (size_t n = 0; n < group.size(); ++n)
    if (wider[n] != wider[group[n]]) return false;
  return true;
}

}  // namespace

void set_surface(const SurfaceInput& surface, double epsilon, OrderingSystem& system,
                 const RunContext& context) {
  if (system.epsilon != epsilon) {
    const PieceTimer assembling(context, "assemble");
    system.pairs.reset();
    system.caps.reset();
    system.metric = make_shift_metric(surface.discretisation, epsilon);
    system.epsilon = epsilon;
  }
}

void set_leans(const SurfaceInput& surface, const Inflation& inflation, const WantedShifts& wanted,
               OrderingSystem& system) {
  ShiftMetric& metric = system.metric;
  metric.lean = lean_term(surface.mesh, surface.scene, metric.scale, system.epsilon);
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(metric.A.rows());
  if (wanted.straight_limbs) rise += limb_rise(surface, inflation);
  if (wanted.close_caps) {
    if (!system.caps || system.caps->tied != tied_parts(surface.scene))
      system.caps = find_caps(surface.mesh, surface.discretisation, surface.scene, metric.A);
    rise += cap_rise(*system.caps, inflation, metric.scale);
    rise += spot_rise(surface.mesh, surface.scene, *system.caps,
                      rise + metric.scale * inflated_heights(inflation.u));
  }
  add_wanted(rise, metric);
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

bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system) {
  const DepthForest& last = system.problem.forest;
  DepthForest forest = build_depth_forest(node_part, pairs);
  if (!is_within(forest.group, last.group)) return false;
  if (forest.gaps == last.gaps) return true;
  forest.group = last.group;
  GapVariables variables = make_gap_variables(forest);
  set_problem({std::move(forest), std::move(variables)}, metric, system);
  return true;
}

}  // namespace relievo::relief
