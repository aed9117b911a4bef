#include "research/rivals/ink_and_ray.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "relief/discretisation/discretisation.h"
#include "relief/layers/layered_mesh.h"
#include "research/rivals/graft.h"
#include "research/rivals/rival.h"
#include "research/rivals/separate_parts.h"
#include "research/rivals/solution.h"

namespace relievo::research {
namespace {

/// Transfers the grafted heights to the separate parts: keeps u and changes g.
void take_over(const Graft& grafted, const std::vector<uint8_t>& changed,
               const SeparateParts& parts, const GradientStencils& gradients, Solution& solution) {
  const std::vector<Point2> slopes = node_gradients(gradients, grafted.h);
  const double thin = 1e-4 * solution.mesh.edge_length;
  for (size_t n = 0; n < parts.joined_node.size(); ++n) {
    const int from = parts.joined_node[n];
    if (changed[from] == 0) continue;
    double& u = solution.inflation.u[n];
    Point2& grad_u = solution.inflation.grad_u[n];
    if (std::abs(u) < thin * thin) {
      // The rim is no longer steep, so its normal follows from the heights.
      u = thin * thin;
      grad_u = {};
    }
    const double f = relief::signed_root(u);
    solution.ordering.h[n] = grafted.h[from];
    solution.ordering.g[n] = grafted.h[from] - f;
    solution.ordering.grad_g[n] = slopes[from] - (1 / (2 * std::abs(f))) * grad_u;
  }
}

/// Flags the visible nodes at which the mask is not dark.
std::vector<uint8_t> brushed(const relief::LayeredMesh& mesh, const Scene& scene,
                             const Image8& mask) {
  std::vector<uint8_t> flags = relief::seen_nodes(mesh);
  for (size_t n = 0; n < flags.size(); ++n) {
    const Point2 p = mesh.vertices[mesh.node_vertex[n]];
    const int x = std::clamp(static_cast<int>(p.x / scene.width * mask.width), 0, mask.width - 1);
    const int y =
        std::clamp(static_cast<int>(p.y / scene.height * mask.height), 0, mask.height - 1);
    if (mask.at(x, y) < 128) flags[n] = 0;
  }
  return flags;
}

}  // namespace

Result<Model> reconstruct_ink_and_ray(const RivalInput& input, const RunContext& context) {
  const SeparateParts parts = separate_parts(input.joined, Roots::open);
  auto solution = inflate_parts(parts.mesh, input.scene, context);
  if (!solution) return solution.error();
  if (Status s = order_parts(*solution, input.scene, context); !s) return s.error();
  std::vector<double> h;
  for (const int n : parts.separate_node) h.push_back(solution->ordering.h[n]);
  const relief::Discretisation discretisation = relief::discretise(input.joined, context);
  if (context.cancelled()) return interrupted_error();
  const Image8& mask = input.options.graft_mask;
  const std::vector<uint8_t> band = mask.empty()
                                        ? band_around_joins(input.joined, input.options.graft)
                                        : brushed(input.joined, input.scene, mask);
  const auto grafted = graft(input.joined, discretisation, h, band, context);
  if (!grafted) return grafted.error();
  take_over(*grafted, band, parts, discretisation.gradients, *solution);
  return model_of(*solution, input.scene, context);
}

}  // namespace relievo::research
