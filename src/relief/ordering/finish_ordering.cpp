#include "relief/ordering/finish_ordering.h"

#include <algorithm>
#include <cmath>

#include "relief/ordering/shift_metric.h"

namespace relievo {
namespace {

double worst_violation(const std::vector<DepthPair>& pairs, const std::vector<double>& h) {
  double worst = 0;
  for (const DepthPair& pair : pairs) {
    const double violation = h[pair.lower] - h[pair.upper];
    worst = std::max(worst, pair.equal ? std::abs(violation) : violation);
  }
  return worst;
}

}  // namespace

Status check_options(const OrderingOptions& options) {
  if (!(options.epsilon > 0 && std::isfinite(options.epsilon)))
    return Error{ErrorCode::usage, "epsilon must be positive", "epsilon"};
  return Done{};
}

Status check_solved(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return Done{};
    case SolveStatus::interrupted:
      return interrupted_error();
    case SolveStatus::iteration_limit:
      return Error{ErrorCode::limit, "the depth order took too many iterations", ""};
    case SolveStatus::not_positive_definite:
      break;
  }
  return Error{ErrorCode::internal, "the depth order has no finite solution", ""};
}

void finish_ordering(const OrderingInput& input, Ordering& ordering) {
  const Eigen::VectorXd f = inflated_heights(input.inflation.u);
  ordering.g.clear();
  ordering.g.reserve(ordering.h.size());
  for (size_t n = 0; n < ordering.h.size(); ++n)
    ordering.g.push_back(ordering.h[n] - f[static_cast<Eigen::Index>(n)]);
  const CreaseStencils& creases = input.discretisation.creases;
  ordering.creases = {creases.corner, crease_gradients(creases, ordering.g)};
  ordering.grad_g = node_gradients(input.discretisation.gradients, ordering.g);
  ordering.max_violation = worst_violation(input.mesh.constraints, ordering.h);
}

}  // namespace relievo
