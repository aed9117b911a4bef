#include "relief/ordering/order_depth.h"

#include <cassert>

#include "relief/discretisation/discretise.h"
#include "relief/ordering/depth_contacts.h"
#include "relief/ordering/finish_ordering.h"

namespace relievo {
namespace {

/// The gaps to start from.
std::vector<uint8_t> first_guess(const LayeredMesh& mesh, const OrderingOptions& options,
                                 const OrderingSystem& system) {
  const DepthProblem& problem = system.system.problem;
  if (!system.h.empty()) return closed_gaps(problem, system.h);
  if (!system.contacts.empty()) return gaps_like(mesh, problem, system.contacts);
  return options.start_active ? problem.variables.bounded : std::vector<uint8_t>();
}

}  // namespace

void prepare_ordering(const SurfaceInput& surface, const OrderingOptions& options,
                      OrderingSystem& system, const RunContext& context) {
  if (!check_options(options)) return;
  set_surface(surface, options.epsilon, system, context);
  set_pairs(surface, system, context);
}

Result<Ordering> order_depth(const OrderingInput& input, const OrderingOptions& options,
                             OrderingSystem& system, const RunContext& context) {
  const LayeredMesh& mesh = input.mesh;
  const SurfaceInput surface{mesh, input.discretisation, input.scene};
  assert(input.inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  context.report("order", 0);
  set_surface(surface, options.epsilon, system, context);
  set_leans(surface, input.inflation, options.straight_limbs, system);
  set_pairs(surface, system, context);
  if (context.cancelled()) return interrupted_error();
  if (system.system.closed.empty()) system.system.closed = first_guess(mesh, options, system);
  Ordering ordering;
  const Eigen::VectorXd f = inflated_heights(input.inflation.u);
  const SolveStatus solved = solve_heights(system.system, system.metric, f, ordering, context);
  if (Status status = check_solved(solved); !status) return status.error();
  finish_ordering(input, ordering);
  system.h = ordering.h;
  system.contacts = contacts_of(mesh, ordering.h);
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
