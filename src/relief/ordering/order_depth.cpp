// The depth order [P eq 10-13]:
//
//   minimise 1/2 (h - f)'A (h - f) - b'(h - f),   A = L + eps M
//   subject to h_lower <= h_upper, or equal, for all depth pairs;    g = h - f
//
//   letter    in the code
//   f         Inflation::u, by inflated_heights
//   A, b      ShiftMetric::A, b
//   pairs     LayeredMesh::constraints
//   h, g      Ordering::h, g
//   eps       OrderingOptions::epsilon
//
// One surface keeps these from one solve to the next:
//
//   letter    in the code                     made again when
//   A         OrderingSystem::metric          epsilon changes
//   b         metric.b (set_wanted)           always
//   pairs     OrderingSystem::depth           the pairs change; its pattern only if others are
//                                             linked

#include "relief/ordering/order_depth.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "kernel/base/stopwatch.h"
#include "relief/ordering/limb_rise.h"

namespace relievo::relief {
namespace {

/// Checks whether all nodes of each group are in one group of `wider` too.
bool is_within(const std::vector<int>& group, const std::vector<int>& wider) {
  for (size_t n = 0; n < group.size(); ++n)
    if (wider[n] != wider[group[n]]) return false;
  return true;
}

/// Returns the gaps of the first active set, #N flags.
std::vector<uint8_t> first_guess(const LayeredMesh& mesh, const OrderingOptions& options,
                                 const OrderingSystem& system) {
  const DepthForest& forest = system.depth.forest;
  if (!system.h.empty()) return closed_gaps(forest, system.h);
  if (!system.contacts.empty()) return gaps_like(mesh, forest, system.contacts);
  return options.start_active ? system.depth.qp.bounded : std::vector<uint8_t>();
}

double worst_violation(const std::vector<DepthPair>& pairs, const std::vector<double>& h) {
  double worst = 0;
  for (const DepthPair& pair : pairs) {
    const double violation = h[pair.lower] - h[pair.upper];
    worst = std::max(worst, pair.equal ? std::abs(violation) : violation);
  }
  return worst;
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

void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context) {
  if (!check_options(options)) return;
  set_metric(surface, options.epsilon, system, context);
  set_pairs(surface, system, context);
}

Result<Ordering> order_depth(const SurfaceInput& surface, const Inflation& inflation,
                             const OrderingOptions& options, OrderingSystem& system,
                             const RunContext& context) {
  const LayeredMesh& mesh = surface.mesh;
  assert(inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(surface.scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  context.report("order", 0);
  set_metric(surface, options.epsilon, system, context);
  set_wanted(surface, inflation, options, system);
  set_pairs(surface, system, context);
  if (context.cancelled()) return interrupted_error();
  if (system.depth.closed.empty()) system.depth.closed = first_guess(mesh, options, system);
  Ordering ordering;
  const Eigen::VectorXd f = inflated_heights(inflation.u);
  const SolveStatus solved = solve_heights(system.depth, system.metric, f, ordering, context);
  if (Status status = check_solved(solved); !status) return status.error();
  finish_ordering(surface, inflation, ordering);
  system.h = ordering.h;
  system.contacts = contacts_of(mesh, ordering.h);
  context.report("order", 1);
  return ordering;
}

Status check_options(const OrderingOptions& options) {
  if (!(options.epsilon > 0 && std::isfinite(options.epsilon)))
    return Error{ErrorCode::usage, "epsilon must be positive", "epsilon"};
  return Done{};
}

Status check_solved(SolveStatus status) {
  if (status == SolveStatus::solved) return Done{};
  if (status == SolveStatus::interrupted) return interrupted_error();
  if (status == SolveStatus::iteration_limit)
    return Error{ErrorCode::limit, "the depth order took too many iterations", ""};
  return Error{ErrorCode::internal, "the depth order has no finite solution", ""};
}

void finish_ordering(const SurfaceInput& surface, const Inflation& inflation, Ordering& ordering) {
  const Eigen::VectorXd f = inflated_heights(inflation.u);
  ordering.g.clear();
  ordering.g.reserve(ordering.h.size());
  for (size_t n = 0; n < ordering.h.size(); ++n)
    ordering.g.push_back(ordering.h[n] - f[static_cast<Eigen::Index>(n)]);
  const CreaseStencils& creases = surface.discretisation.creases;
  ordering.creases = {creases.corner, crease_gradients(creases, ordering.g)};
  ordering.grad_g = node_gradients(surface.discretisation.gradients, ordering.g);
  ordering.max_violation = worst_violation(surface.mesh.constraints, ordering.h);
}

}  // namespace relievo::relief
