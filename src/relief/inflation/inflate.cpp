#include "relief/inflation/inflate.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "relief/discretisation/discretisation.h"
#include "relief/inflation/poisson_system.h"
#include "relief/inflation/raise_bumps.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

using Eigen::VectorXd;

/// Where 1 - alpha is smaller, the condition is u = 0.
constexpr double stiffest = 1e-9;

/// alpha / (1 - alpha) is at least so much where a node is attached: nearer to the join the two
/// nodes are as good as one.
constexpr double softest = 1e-3;

PoissonBoundary boundary_conditions(const LayeredMesh& mesh, const InflationOptions& options) {
  PoissonBoundary boundary;
  for (const NodeRole role : mesh.node_role) boundary.fixed.push_back(role == NodeRole::outline);
  boundary.spring = VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_role.size()));
  for (const RampNode& node : mesh.ramp_nodes) {
    const RobinRamp& ramp = mesh.ramps[node.ramp];
    const double alpha0 = ramp.alpha0 >= 0 ? ramp.alpha0 : options.alpha0;
    const double rho = ramp.rho >= 0 ? ramp.rho : options.rho;
    const double length = rho * ramp.length;
    const double slack = (1 - alpha0) * (1 - node.t);
    boundary.link.push_back(0);
    if (slack <= stiffest || !(length > 0)) {
      boundary.fixed[node.node] = 1;
      continue;
    }
    const double ratio = (1 - slack) / slack;
    boundary.spring[node.node] += ratio / length * node.mass;
    const double hold = 1 / std::max(ratio, softest);
    boundary.link.back() = hold * hold / length * node.mass;
  }
  return boundary;
}

Status check_held(const LayeredMesh& mesh, const std::vector<int>& surface, const Scene& scene,
                  const PoissonBoundary& boundary) {
  std::vector<uint8_t> held(mesh.node_vertex.size(), 0);
  for (size_t n = 0; n < held.size(); ++n)
    if (boundary.fixed[n] != 0 || boundary.spring[static_cast<Eigen::Index>(n)] > 0)
      held[surface[n]] = 1;
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (held[surface[mesh.faces[f][0]]] == 0)
      return Error{ErrorCode::bad_input,
                   "nothing holds the surface of this part at height 0: its outline is all join",
                   scene.parts[mesh.face_part[f]].id,
                   {CulpritList::parts, static_cast<size_t>(mesh.face_part[f])}};
  return Done{};
}

/// On surfaces whose sources all have one sign u has it too; obtuse faces may spoil it slightly.
void restore_sign(const InflationInput& input, VectorXd& u) {
  const std::vector<int> signs =
      surface_signs(input.mesh, input.discretisation.surface, input.scene);
  for (Eigen::Index n = 0; n < u.size(); ++n)
    if (signs[n] * u[n] < 0) u[n] = 0;
}

Status check_options(const InflationOptions& options) {
  if (!(options.alpha0 >= 0 && options.alpha0 <= 1))
    return Error{ErrorCode::usage, "alpha0 must lie between 0 and 1", "alpha0"};
  if (!(options.rho > 0 && std::isfinite(options.rho)))
    return Error{ErrorCode::usage, "rho must be positive", "rho"};
  return Done{};
}

}  // namespace

Status check_held(const LayeredMesh& mesh, const Scene& scene, const InflationOptions& options) {
  return check_held(mesh, joined_surfaces(mesh), scene, boundary_conditions(mesh, options));
}

Result<Inflation> inflate(const InflationInput& input, const InflationOptions& options,
                          PoissonSystem& system, const RunContext& context) {
  const auto& [mesh, discretisation, scene] = input;
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  context.report("inflate", 0);
  PoissonBoundary boundary = boundary_conditions(mesh, options);
  if (Status status = check_held(mesh, discretisation.surface, scene, boundary); !status)
    return status.error();

  const InflationTerms terms = inflation_terms(mesh, scene, discretisation.scale);
  boundary.spring += terms.screening;
  std::optional<VectorXd> u = system.solve(boundary, terms.load, context);
  if (context.cancelled()) return interrupted_error();
  if (!u) return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
  restore_sign(input, *u);
  Inflation inflation = make_inflation(discretisation.gradients, *u, discretisation.scale);
  raise_bumps(input, options, inflation);
  context.report("inflate", 1);
  return inflation;
}

Result<Inflation> inflate(const LayeredMesh& mesh, const Scene& scene,
                          const InflationOptions& options, const RunContext& context) {
  const Discretisation discretisation = discretise(mesh, context);
  if (context.cancelled()) return interrupted_error();
  PoissonSystem system(mesh, discretisation, Refactorisation::complete, context);
  return inflate({mesh, discretisation, scene}, options, system, context);
}

}  // namespace relievo::relief
