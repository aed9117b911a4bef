#include "research/rivals/stacked_parts.h"

#include <cmath>
#include <utility>
#include <vector>

#include "relief/session/build_relief.h"
#include "relief/surface/assemble_model.h"
#include "research/rivals/rival.h"
#include "research/rivals/separate_parts.h"
#include "research/rivals/solution.h"

namespace relievo::research {
namespace {

/// Replaces the profile f = sgn(u) sqrt|u| by the parabola f = u / sqrt(max |u| of the part), and
/// returns it as an inflation whose u is f |f|.
relief::Inflation parabolas(const relief::LayeredMesh& mesh, const relief::Inflation& inflation) {
  std::vector<double> most(mesh.part_count, 0);
  for (size_t n = 0; n < inflation.u.size(); ++n) {
    double& of_part = most[mesh.node_part[n]];
    of_part = std::max(of_part, std::abs(inflation.u[n]));
  }
  relief::Inflation result = inflation;
  for (size_t n = 0; n < inflation.u.size(); ++n) {
    const double apex = most[mesh.node_part[n]];
    const double f = apex > 0 ? inflation.u[n] / std::sqrt(apex) : 0;
    result.u[n] = f * std::abs(f);
    result.grad_u[n] =
        apex > 0 ? (2 * std::abs(f) / std::sqrt(apex)) * inflation.grad_u[n] : Point2{};
  }
  return result;
}

Result<Model> inflated_and_ordered(const relief::LayeredMesh& mesh, const Scene& scene,
                                   const RunContext& context) {
  auto solution = inflate_parts(mesh, scene, context);
  if (!solution) return solution.error();
  if (Status s = order_parts(*solution, scene, context); !s) return s.error();
  return model_of(*solution, scene, context);
}

}  // namespace

Result<Model> reconstruct_ours(const RivalInput& input, const RunContext& context) {
  relief::ReliefOptions options;
  options.layers.edge_length = input.joined.edge_length;
  const auto relief = relief::build_relief(input.scene, options, context);
  if (!relief) return relief.error();
  return relief::assemble_model({relief->layers, relief->inflation, relief->ordering, input.scene},
                                {}, context);
}

Result<Model> reconstruct_with_firm_ends(const RivalInput& input, const RunContext& context) {
  return inflated_and_ordered(input.joined, input.scene, context);
}

Result<Model> reconstruct_pillows(const RivalInput& input, const RunContext& context) {
  return inflated_and_ordered(separate_parts(input.joined, Roots::closed).mesh, input.scene,
                              context);
}

Result<Model> reconstruct_parabolic(const RivalInput& input, const RunContext& context) {
  auto solution =
      inflate_parts(separate_parts(input.joined, Roots::closed).mesh, input.scene, context);
  if (!solution) return solution.error();
  solution->inflation = parabolas(solution->mesh, solution->inflation);
  if (Status s = order_parts(*solution, input.scene, context); !s) return s.error();
  make_linear(solution->ordering.h, *solution);
  return model_of(*solution, input.scene, context);
}

}  // namespace relievo::research
