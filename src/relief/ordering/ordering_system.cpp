// The pieces of the depth order that one surface keeps from one solve to the next:
//
//   minimise 1/2 (h - f)'A (h - f) - b'(h - f)    under the depth pairs
//
//   letter    in the code                     made again when
//   A         OrderingSystem::metric          epsilon changes
//   b         metric.b (set_wanted)           always
//   pairs     OrderingSystem::depth           the pairs change; its pattern only if others are
//   linked

#include "relief/ordering/ordering_system.h"

#include <utility>

#include "kernel/base/stopwatch.h"
#include "relief/ordering/cap_rise.h"
#include "relief/ordering/limb_rise.h"
#include "relief/ordering/shift_metric.h"

namespace relievo::relief {
namespace {

/// Checks whether all nodes of each group are in one group of `wider` too.
bool is_within(const std::vector<int>& group, const std::vector<int>& wider) {
  for (size_t n = 0; n < group.size(); ++n)
    if (wider[n] != wider[group[n]]) return false;
  return true;
}

}  // namespace

void set_metric(const SurfaceInput& surface, double epsilon, OrderingSystem& system,
                const RunContext& context) {
  if (system.epsilon == epsilon) return;
  const PieceTimer assembling(context, "assemble");
  system.pairs.reset();
  system.tied.reset();
  system.metric = make_shift_metric(surface.discretisation, epsilon);
  system.epsilon = epsilon;
}

void set_wanted(const SurfaceInput& surface, const Inflation& inflation,
                const OrderingOptions& options, OrderingSystem& system) {
  const auto& [mesh, discretisation, scene] = surface;
  ShiftMetric& metric = system.metric;
  set_slopes(mesh, scene, system.epsilon, metric);
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(metric.A.rows());
  if (options.straight_limbs) rise += limb_rise(surface, inflation);
  if (options.close_caps) {
    std::vector<std::set<int>> tied = tied_parts(scene);
    if (system.tied != tied) {
      system.caps = find_caps(surface, tied, metric.A);
      system.tied = std::move(tied);
    }
    rise += cap_rise(system.caps, inflation, metric.scale);
    rise += spot_rise(surface, *system.tied, system.caps,
                      rise + metric.scale * inflated_heights(inflation.u));
  }
  add_wanted(rise, metric);
}

void set_pairs(const SurfaceInput& surface, OrderingSystem& system, const RunContext& context) {
  const std::vector<DepthPair>& pairs = surface.mesh.constraints;
  const std::vector<int>& node_part = surface.mesh.node_part;
  const bool serves = system.pairs && (*system.pairs == pairs ||
                                       select_pairs(node_part, pairs, system.metric, system.depth));
  if (!serves) {
    PieceTimer sorting(context, "assemble");
    DepthForest forest = build_depth_forest(node_part, pairs);
    sorting.stop();
    system.depth =
        make_depth_system(std::move(forest), system.metric, surface.discretisation.elimination,
                          std::move(system.depth.factor), context);
  }
  system.pairs = pairs;
  if (context.cancelled()) system.pairs.reset();  // the system may be half made
}

bool select_pairs(const std::vector<int>& node_part, const std::vector<DepthPair>& pairs,
                  const ShiftMetric& metric, DepthSystem& system) {
  DepthForest forest = build_depth_forest(node_part, pairs);
  if (!is_within(forest.group, system.forest.group)) return false;
  if (forest.gaps == system.forest.gaps) return true;
  forest.group = system.forest.group;
  set_forest(std::move(forest), metric, system);
  return true;
}

}  // namespace relievo::relief
