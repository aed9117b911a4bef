#include "relief/ordering/order_rounds.h"

#include <algorithm>
#include <cmath>

#include "relief/layers/joined_surface.h"
#include "relief/ordering/overlap.h"
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
  if (options.max_rounds < 0)
    return Error{ErrorCode::usage, "the number of rounds must not be negative", "max_rounds"};
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

Result<Ordering> order_in_rounds(const LayeredMesh& mesh, const Scene& scene, double scale,
                                 int max_rounds, const HeightSolver& solve) {
  const std::vector<FacePair> stacked = stacked_faces(mesh, scene);
  std::vector<DepthPair> pairs = mesh.constraints;
  Ordering ordering;
  for (;;) {
    if (Status status = solve(pairs, ordering); !status) return status.error();
    if (ordering.rounds == max_rounds) break;
    const std::vector<DepthPair> crossed =
        crossed_nodes(mesh, stacked, ordering.h, crossing_tolerance / scale);
    if (crossed.empty()) break;
    ++ordering.rounds;
    ordering.interior_pairs += static_cast<int>(crossed.size());
    pairs.insert(pairs.end(), crossed.begin(), crossed.end());
  }
  ordering.max_violation = worst_violation(pairs, ordering.h);
  return ordering;
}

void finish_ordering(const OrderingInput& input, Ordering& ordering) {
  const Eigen::VectorXd f = inflated_heights(input.inflation.u);
  ordering.g.clear();
  ordering.g.reserve(ordering.h.size());
  for (size_t n = 0; n < ordering.h.size(); ++n)
    ordering.g.push_back(ordering.h[n] - f[static_cast<Eigen::Index>(n)]);
  ordering.grad_g = node_gradients(input.discretisation.gradients, ordering.g);
  const OverlapSamples samples =
      sample_overlap(input.mesh, stacked_faces(input.mesh, input.scene), input.inflation.u,
                     ordering.g, crossing_tolerance / input.discretisation.scale);
  ordering.overlap_samples = samples.count;
  ordering.overlap_worst = samples.worst;
}

void finish_ordering(const LayeredMesh& mesh, const Scene& scene, const Inflation& inflation,
                     Ordering& ordering) {
  Discretisation discretisation;
  discretisation.scale = scene_scale(mesh);
  const std::vector<Point2> positions = node_positions(mesh);
  discretisation.gradients = gradient_stencils({positions, mesh.faces});
  finish_ordering({mesh, discretisation, inflation, scene}, ordering);
}

}  // namespace relievo
