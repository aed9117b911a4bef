// Inflation of all parts by one Poisson problem [P eq 7-9], in scene units:
//
//   (L + B + K) u = M c,      u = 0 on outlines,      f = sgn(u) sqrt|u|
//
// u is d|d| times the paper's f tilde. The paper's Robin condition
//
//   alpha u + (1 - alpha) l du/dn = 0,    alpha = alpha0 + (1 - alpha0) t,    l = rho (ramp length)
//
// holds on ramps, where t grows from 0 at the join's end to 1 at the exit. A ramp node that stands
// for the length m of outline adds to B
//
//   beta m    on the diagonal,                        beta  = alpha / ((1 - alpha) l)
//   kappa m   between the node and the one below it,  kappa = ((1 - alpha) / alpha)^2 / l
//
//   letter         in the code
//   L, M           Discretisation::L, mass
//   M c            inflation_load
//   K              inflation_screening, flat parts only
//   beta m + K     PoissonBoundary::diagonal
//   kappa m        PoissonBoundary::coupling
//   u = 0          PoissonBoundary::fixed
//   1 - alpha      neumann in boundary_conditions

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

/// A smaller 1 - alpha counts as Dirichlet.
constexpr double least_neumann = 1e-9;

/// Lower limit of alpha / (1 - alpha) in kappa. The two nodes are practically one below it.
constexpr double least_ratio = 1e-3;

PoissonBoundary boundary_conditions(const LayeredMesh& mesh, const InflationOptions& options) {
  PoissonBoundary boundary;
  for (const NodeRole role : mesh.node_role) boundary.fixed.push_back(role == NodeRole::outline);
  boundary.diagonal = VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_role.size()));
  for (const RampNode& node : mesh.ramp_nodes) {
    const RobinRamp& ramp = mesh.ramps[node.ramp];
    const double alpha0 = ramp.alpha0 >= 0 ? ramp.alpha0 : options.alpha0;
    const double rho = ramp.rho >= 0 ? ramp.rho : options.rho;
    const double length = rho * ramp.length;
    const double neumann = (1 - alpha0) * (1 - node.t);
    boundary.coupling.push_back(0);
    if (neumann <= least_neumann || !(length > 0)) {
      boundary.fixed[node.node] = 1;
      continue;
    }
    const double ratio = (1 - neumann) / neumann;
    boundary.diagonal[node.node] += ratio / length * node.mass;
    const double inverse = 1 / std::max(ratio, least_ratio);
    boundary.coupling.back() = inverse * inverse / length * node.mass;
  }
  return boundary;
}

/// `surface`: #N, the joined surface of each node.
Status check_fixed(const LayeredMesh& mesh, const std::vector<int>& surface, const Scene& scene,
                   const PoissonBoundary& boundary) {
  std::vector<uint8_t> is_fixed(mesh.node_vertex.size(), 0);
  for (size_t n = 0; n < is_fixed.size(); ++n)
    if (boundary.fixed[n] != 0 || boundary.diagonal[static_cast<Eigen::Index>(n)] > 0)
      is_fixed[surface[n]] = 1;
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (is_fixed[surface[mesh.faces[f][0]]] == 0)
      return Error{ErrorCode::bad_input,
                   "nothing fixes this part to the drawing plane: its whole outline is joined to "
                   "other parts",
                   scene.parts[mesh.face_part[f]].id,
                   {CulpritList::parts, static_cast<size_t>(mesh.face_part[f])}};
  return Done{};
}

/// Sets u to 0 where obtuse faces give it a sign that the maximum principle excludes.
void restore_sign(const SurfaceInput& surface, VectorXd& u) {
  const std::vector<int> signs =
      surface_signs(surface.mesh, surface.discretisation.surface, surface.scene);
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

Status check_fixed(const LayeredMesh& mesh, const Scene& scene, const InflationOptions& options) {
  return check_fixed(mesh, joined_surfaces(mesh), scene, boundary_conditions(mesh, options));
}

Result<Inflation> inflate(const SurfaceInput& surface, const InflationOptions& options,
                          PoissonSystem& system, const RunContext& context) {
  const auto& [mesh, discretisation, scene] = surface;
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  context.report("inflate", 0);
  PoissonBoundary boundary = boundary_conditions(mesh, options);
  if (Status status = check_fixed(mesh, discretisation.surface, scene, boundary); !status)
    return status.error();

  boundary.diagonal += inflation_screening(mesh, scene, discretisation.scale);
  const VectorXd load = inflation_load(mesh, scene, discretisation.scale);
  std::optional<VectorXd> u = system.solve(boundary, load, context);
  if (context.cancelled()) return interrupted_error();
  if (!u) return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
  restore_sign(surface, *u);
  Inflation inflation = make_inflation(discretisation.gradients, *u, discretisation.scale);
  raise_bumps(surface, options, inflation);
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
