#include "relief/inflation/inflate.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "kernel/base/piece_timer.h"
#include "kernel/operators/laplacian.h"
#include "kernel/solvers/sparse_cholesky.h"
#include "relief/inflation/poisson_terms.h"
#include "relief/layers/joined_surface.h"

namespace relievo {
namespace {

using Eigen::VectorXd;

/// Where 1 - alpha is smaller, the condition is u = 0.
constexpr double stiffest = 1e-9;

/// What holds u at each node: fixed to 0, or a spring to 0 (diagonal of B_beta, no unit).
struct Boundary {
  std::vector<uint8_t> fixed;
  VectorXd spring;
};

Boundary boundary_conditions(const LayeredMesh& mesh, const InflationOptions& options) {
  Boundary boundary;
  for (const NodeRole role : mesh.node_role) boundary.fixed.push_back(role == NodeRole::outline);
  boundary.spring = VectorXd::Zero(static_cast<Eigen::Index>(mesh.node_role.size()));
  for (const RampNode& node : mesh.ramp_nodes) {
    const RobinRamp& ramp = mesh.ramps[node.ramp];
    const double alpha0 = ramp.alpha0 >= 0 ? ramp.alpha0 : options.alpha0;
    const double rho = ramp.rho >= 0 ? ramp.rho : options.rho;
    const double length = options.units == RobinUnits::literal ? 1 : rho * ramp.length;
    const double slack = (1 - alpha0) * (1 - node.t);
    if (slack <= stiffest || !(length > 0))
      boundary.fixed[node.node] = 1;
    else
      boundary.spring[node.node] += (1 - slack) / (slack * length) * node.mass;
  }
  return boundary;
}

Status check_held(const LayeredMesh& mesh, const Scene& scene, const Boundary& boundary) {
  DisjointSets surfaces = connected_surfaces(mesh);
  std::vector<uint8_t> held(mesh.node_vertex.size(), 0);
  for (size_t n = 0; n < held.size(); ++n)
    if (boundary.fixed[n] != 0 || boundary.spring[static_cast<Eigen::Index>(n)] > 0)
      held[surfaces.find(static_cast<int>(n))] = 1;
  for (size_t f = 0; f < mesh.faces.size(); ++f)
    if (held[surfaces.find(mesh.faces[f][0])] == 0)
      return Error{ErrorCode::bad_input,
                   "nothing holds the surface of this part at height 0: its outline is all join",
                   scene.parts[mesh.face_part[f]].id};
  return Done{};
}

/// Solves (L + B) u = load with u = 0 on fixed nodes; empty when there is no finite solution.
VectorXd solve_poisson(const SparseMatrix& L, const Boundary& boundary, const VectorXd& load,
                       const RunContext& context) {
  std::vector<int> unknown(boundary.fixed.size(), -1);
  int unknowns = 0;
  for (size_t n = 0; n < unknown.size(); ++n)
    if (boundary.fixed[n] == 0) unknown[n] = unknowns++;
  VectorXd b(unknowns);
  for (size_t n = 0; n < unknown.size(); ++n)
    if (unknown[n] >= 0) b[unknown[n]] = load[static_cast<Eigen::Index>(n)];

  SparseMatrix A = lower_block(L, unknown, unknowns);
  for (size_t n = 0; n < unknown.size(); ++n)
    if (unknown[n] >= 0)
      A.coeffRef(unknown[n], unknown[n]) += boundary.spring[static_cast<Eigen::Index>(n)];
  SparseCholesky factor;
  PieceTimer analysing(context, "analyse");
  factor.analyse(A);
  analysing.stop();
  if (!factor.factorise(A)) return {};
  VectorXd x = factor.solve(b);
  x += factor.solve(b - multiply_symmetric(A, x));
  if (!x.allFinite()) return {};

  VectorXd u = VectorXd::Zero(load.size());
  for (size_t n = 0; n < unknown.size(); ++n)
    if (unknown[n] >= 0) u[static_cast<Eigen::Index>(n)] = x[unknown[n]];
  return u;
}

/// On surfaces whose sources all have one sign u has it too; obtuse faces may spoil it slightly.
void restore_sign(const LayeredMesh& mesh, const Scene& scene, VectorXd& u) {
  const std::vector<int> signs = surface_signs(mesh, scene);
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

Result<Inflation> inflate(const LayeredMesh& mesh, const Scene& scene,
                          const InflationOptions& options, const RunContext& context) {
  assert(static_cast<int>(scene.parts.size()) == mesh.part_count);
  if (Status status = check_options(options); !status) return status.error();
  context.report("inflate", 0);
  const Boundary boundary = boundary_conditions(mesh, options);
  if (Status status = check_held(mesh, scene, boundary); !status) return status.error();

  const double scale = scene_scale(mesh);
  const std::vector<Point2> positions = node_positions(mesh, scale);
  const FlatMesh flat{positions, mesh.faces};
  PieceTimer assembling(context, "assemble");
  const SparseMatrix L = stiffness_matrix(flat);
  const VectorXd load = inflation_load(flat, mesh, scene);
  assembling.stop();
  if (context.cancelled()) return interrupted_error();
  VectorXd u = solve_poisson(L, boundary, load, context);
  if (u.size() != load.size())
    return Error{ErrorCode::internal, "the inflation has no finite solution", ""};
  if (context.cancelled()) return interrupted_error();
  restore_sign(mesh, scene, u);
  context.report("inflate", 1);
  return make_inflation(mesh, u, scale);
}

}  // namespace relievo
