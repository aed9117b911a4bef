#include "research/rivals/solution.h"

#include <optional>
#include <utility>

#include "relief/discretisation/discretisation.h"
#include "relief/hiding/hide_sheets.h"
#include "relief/inflation/inflate.h"
#include "relief/ordering/order_depth.h"
#include "relief/surface/assemble_model.h"

namespace relievo::research {

Result<Solution> inflate_parts(relief::LayeredMesh mesh, const Scene& scene,
                               const RunContext& context) {
  Solution solution{std::move(mesh), {}, {}, {}};
  solution.discretisation = relief::discretise(solution.mesh, context);
  if (context.cancelled()) return interrupted_error();
  relief::PoissonSystem system(solution.mesh, solution.discretisation, Refactorisation::complete,
                               context);
  relief::InflationOptions options;
  options.alpha0 = 1;
  auto inflation =
      relief::inflate({solution.mesh, solution.discretisation, scene}, options, system, context);
  if (!inflation) return inflation.error();
  solution.inflation = std::move(*inflation);
  return solution;
}

Status order_parts(Solution& solution, const Scene& scene, const RunContext& context) {
  relief::OrderingSystem system;
  auto ordering = relief::order_depth({solution.mesh, solution.discretisation, scene},
                                      solution.inflation, {}, system, context);
  if (!ordering) return ordering.error();
  solution.ordering = std::move(*ordering);
  return Done{};
}

void make_linear(const std::vector<double>& h, Solution& solution) {
  // Normals need a non-zero inflation: 1 px everywhere.
  solution.inflation.u.assign(h.size(), 1);
  solution.inflation.grad_u.assign(h.size(), {0, 0});
  solution.ordering.h = h;
  solution.ordering.g = h;
  for (double& g : solution.ordering.g) g -= 1;
  solution.ordering.grad_g = node_gradients(solution.discretisation.gradients, h);
  solution.ordering.creases = {};
}

Result<Model> model_of(const Solution& solution, const Scene& scene, const RunContext& context) {
  std::optional<relief::FlapSystem> flaps;
  relief::Inflation inflation = solution.inflation;
  relief::Ordering ordering = solution.ordering;
  relief::hide_sheets({solution.mesh, solution.discretisation, scene}, flaps, inflation, ordering,
                      context);
  if (context.cancelled()) return interrupted_error();
  return relief::assemble_model({solution.mesh, inflation, ordering, scene}, {}, context);
}

}  // namespace relievo::research
