#include "relief/ordering/order_depth.h"

#include <cassert>
#include <utility>

#include "relief/discretisation/discretise.h"
#include "relief/ordering/order_rounds.h"

namespace relievo {
namespace {

/// The gaps to start from; `last_h` are the heights of the last round, if any.
std::vector<uint8_t> first_guess(const LayeredMesh& mesh, const OrderingOptions& options,
                                 const OrderingSystem& system, const std::vector<double>& last_h) {
  const DepthProblem& problem = system.system.problem;
  if (!last_h.empty()) return closed_gaps(problem, last_h);
  if (!system.h.empty()) return closed_gaps(problem, system.h);
  if (!system.contacts.empty()) return gaps_like(mesh, problem, system.contacts);
  return options.start_active ? problem.variables.bounded : std::vector<uint8_t>();
}

RoundPlan plan_for(const OrderingSystem& system, const LayeredMesh& mesh,
                   const OrderingOptions& options) {
  return plan_rounds(system.stacked, system.inside, mesh.node_vertex.size(), options.max_rounds);
}

}  // namespace

void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context) {
  if (!check_options(options)) return;
  set_surface(surface, options.epsilon, system, context);
  set_pairs(surface, first_pairs(surface.mesh, plan_for(system, surface.mesh, options)), system,
            context);
}

Result<Ordering> order_depth(const OrderingInput& input, const OrderingOptions& options,
                             OrderingSystem& system, const RunContext& context) {
  const LayeredMesh& mesh = input.mesh;
  const SurfaceInput surface{mesh, input.discretisation, input.scene};
  assert(input.inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  set_surface(surface, options.epsilon, system, context);
  set_leans(mesh, input.scene, system);
  RoundPlan plan = plan_for(system, mesh, options);
  const Eigen::VectorXd f = inflated_heights(input.inflation.u);
  const auto solve = [&](const std::vector<DepthPair>& pairs, Ordering& ordering) -> Status {
    context.report("order", ordering.rounds / (options.max_rounds + 1.0));
    set_pairs(surface, pairs, system, context);
    if (context.cancelled()) return interrupted_error();
    if (system.system.closed.empty())
      system.system.closed = first_guess(mesh, options, system, ordering.h);
    return check_solved(solve_heights(system.system, system.metric, f, ordering, context));
  };
  Result<Ordering> ordering = order_in_rounds(mesh, system.metric.scale, plan, solve);
  if (!ordering) return ordering;
  finish_ordering(input, system.stacked.faces, *ordering);
  system.inside = std::move(plan.inside);
  system.h = ordering->h;
  system.contacts = contacts_of(mesh, system.stacked, ordering->h);
  context.report("order", 1);
  return ordering;
}

Result<Ordering> order_depth(const LayeredMesh& mesh, const Inflation& inflation,
                             const Scene& scene, const OrderingOptions& options,
                             const RunContext& context) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  OrderingSystem system;
  return order_depth({mesh, discretisation, inflation, scene}, options, system, context);
}

}  // namespace relievo
