#include "relief/ordering/order_depth.h"

#include <cassert>
#include <utility>

#include "kernel/base/piece_timer.h"
#include "relief/discretisation/discretise.h"
#include "relief/ordering/order_rounds.h"
#include "relief/ordering/pair_selection.h"

namespace relievo {
namespace {

/// Solves with the system, which is made anew where it cannot serve.
class HeightsUnderPairs {
 public:
  HeightsUnderPairs(const OrderingInput& input, const OrderingOptions& options,
                    OrderingSystem& system, const RunContext& context)
      : input_(input),
        options_(options),
        system_(system),
        context_(context),
        f_(inflated_heights(input.inflation.u)) {}

  Status solve(const std::vector<DepthPair>& pairs, Ordering& ordering) {
    context_.report("order", ordering.rounds / (options_.max_rounds + 1.0));
    if (!serves(pairs)) make_system(pairs, ordering);
    system_.pairs = pairs;
    if (context_.cancelled()) {  // it may be half made
      system_.pairs.reset();
      return interrupted_error();
    }
    return check_solved(solve_heights(system_.system, system_.metric, f_, ordering, context_));
  }

 private:
  bool serves(const std::vector<DepthPair>& pairs) {
    if (!system_.pairs) return false;
    return system_.pairs == pairs || select_pairs(input_.mesh.node_part, pairs, system_.system);
  }

  void make_system(const std::vector<DepthPair>& pairs, const Ordering& ordering) {
    PieceTimer sorting(context_, "assemble");
    const DepthProblem problem = make_depth_problem(input_.mesh.node_part, pairs);
    sorting.stop();
    system_.system = make_depth_system(problem, system_.metric, input_.discretisation.elimination,
                                       std::move(system_.system.factor), context_);
    system_.system.closed = first_guess(problem, ordering.h);
  }

  /// The gaps to start from; `last_h` are the heights of the last round, if any.
  std::vector<uint8_t> first_guess(const DepthProblem& problem,
                                   const std::vector<double>& last_h) const {
    if (!last_h.empty()) return closed_gaps(problem, last_h);
    if (!system_.h.empty()) return closed_gaps(problem, system_.h);
    if (!system_.contacts.empty()) return gaps_like(input_.mesh, problem, system_.contacts);
    return options_.start_active ? problem.variables.bounded : std::vector<uint8_t>();
  }

  const OrderingInput& input_;
  const OrderingOptions& options_;
  OrderingSystem& system_;
  const RunContext& context_;
  Eigen::VectorXd f_;
};

/// Brings what does not depend on the inflation up to date.
void prepare(const OrderingInput& input, const OrderingOptions& options, OrderingSystem& system,
             const RunContext& context) {
  if (system.epsilon != options.epsilon) {
    const PieceTimer assembling(context, "assemble");
    system.pairs.reset();
    system.metric = make_shift_metric(input.discretisation, options.epsilon);
    system.epsilon = options.epsilon;
  }
  std::vector<FacePair> faces = stacked_faces(input.mesh, input.scene);
  if (faces != system.stacked.faces) system.stacked = stacked_nodes(input.mesh, std::move(faces));
}

}  // namespace

Result<Ordering> order_depth(const OrderingInput& input, const OrderingOptions& options,
                             OrderingSystem& system, const RunContext& context) {
  const LayeredMesh& mesh = input.mesh;
  assert(input.inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  prepare(input, options, system, context);
  RoundPlan plan =
      plan_rounds(system.stacked, system.inside, mesh.node_vertex.size(), options.max_rounds);
  HeightsUnderPairs heights(input, options, system, context);
  const auto solve = [&](const std::vector<DepthPair>& pairs, Ordering& ordering) {
    return heights.solve(pairs, ordering);
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
