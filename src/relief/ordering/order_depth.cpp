#include "relief/ordering/order_depth.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "kernel/base/piece_timer.h"
#include "relief/discretisation/discretise.h"
#include "relief/ordering/order_rounds.h"

namespace relievo {
namespace {

using Round = OrderingSystem::Round;

/// Solves one round after the other with the system's rounds.
class RoundSolver {
 public:
  RoundSolver(const OrderingInput& input, const OrderingOptions& options, OrderingSystem& system,
              const RunContext& context)
      : input_(input),
        options_(options),
        system_(system),
        context_(context),
        f_(inflated_heights(input.inflation.u)) {}

  Status solve(const std::vector<DepthPair>& pairs, Ordering& ordering) {
    context_.report("order", ordering.rounds / (options_.max_rounds + 1.0));
    Round& round = round_for(pairs, ordering);
    if (context_.cancelled()) {  // it may be half made
      system_.rounds.clear();
      return interrupted_error();
    }
    return check_solved(solve_heights(round.system, system_.metric, f_, ordering, context_));
  }

 private:
  Round& round_for(const std::vector<DepthPair>& pairs, const Ordering& ordering) {
    std::vector<Round>& rounds = system_.rounds;
    const size_t number = system_.keep_rounds ? static_cast<size_t>(ordering.rounds) : 0;
    if (number < rounds.size() && rounds[number].pairs == pairs) return rounds[number];
    SparseCholesky factor;
    if (number < rounds.size()) factor = std::move(rounds[number].system.factor);
    rounds.resize(number);
    PieceTimer sorting(context_, "assemble");
    const DepthProblem problem = make_depth_problem(input_.mesh.node_part, pairs);
    sorting.stop();
    rounds.push_back(
        {pairs, make_depth_system(problem, system_.metric, input_.discretisation.elimination,
                                  std::move(factor), context_)});
    rounds.back().system.closed = first_guess(problem, ordering.h);
    return rounds.back();
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

}  // namespace

Result<Ordering> order_depth(const OrderingInput& input, const OrderingOptions& options,
                             OrderingSystem& system, const RunContext& context) {
  const LayeredMesh& mesh = input.mesh;
  assert(input.inflation.u.size() == mesh.node_vertex.size());
  assert(static_cast<int>(input.scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  if (system.epsilon != options.epsilon) {
    const PieceTimer assembling(context, "assemble");
    system.rounds.clear();
    system.metric = make_shift_metric(input.discretisation, options.epsilon);
    system.epsilon = options.epsilon;
  }
  RoundSolver solver(input, options, system, context);
  const auto solve = [&](const std::vector<DepthPair>& pairs, Ordering& ordering) {
    return solver.solve(pairs, ordering);
  };
  Result<Ordering> ordering =
      order_in_rounds(mesh, input.scene, system.metric.scale, options.max_rounds, solve);
  if (!ordering) return ordering;
  finish_ordering(input, *ordering);
  if (system.keep_rounds)
    system.rounds.resize(std::min(system.rounds.size(), static_cast<size_t>(ordering->rounds) + 1));
  system.h = ordering->h;
  system.contacts = contacts_of(mesh, system.rounds.back().system);
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
