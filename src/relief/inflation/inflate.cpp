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
//
// Bumps: joined parts whose outline does not leave the lower surface. In scene units,
//
//   f <- f + w,    w = sgn(v) sqrt(|v| psi^3)
//   (L + K) v = M c     with v = 0 on the outline of the bump
//   L psi = 0           with psi = alpha on the outline
//
//   letter    in the code
//   L, M, K   stiffness_matrix, lumped_mass and screening_density times M, on the bump's faces
//   alpha     Bump::alpha
//   v, psi    v, psi in rise_of
//   w         result of rise_of

#include "relief/inflation/inflate.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// A smaller 1 - alpha counts as Dirichlet.
constexpr double least_neumann = 1e-9;

/// Lower limit of alpha / (1 - alpha) in kappa. The two nodes are practically one below it.
constexpr double least_ratio = 1e-3;

PoissonBoundary boundary_conditions(const LayeredMesh& mesh, const InflationOptions& options) {
  PoissonBoundary boundary;
  for (const NodeRole role : mesh.node_role) boundary.fixed.push_back(role == NodeRole::outline);
  boundary.diagonal = VectorXd::Zero(static_cast<Index>(mesh.node_role.size()));
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
    if (boundary.fixed[n] != 0 || boundary.diagonal[static_cast<Index>(n)] > 0)
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
  for (Index n = 0; n < u.size(); ++n)
    if (signs[n] * u[n] < 0) u[n] = 0;
}

Status check_options(const InflationOptions& options) {
  if (!(options.alpha0 >= 0 && options.alpha0 <= 1))
    return Error{ErrorCode::usage, "alpha0 must lie between 0 and 1", "alpha0"};
  if (!(options.rho > 0 && std::isfinite(options.rho)))
    return Error{ErrorCode::usage, "rho must be positive", "rho"};
  return Done{};
}

/// The faces of one bump on nodes of its own.
struct Bump {
  std::vector<int> nodes;         ///< node of the mesh
  std::vector<Point2> positions;  ///< scene units
  std::vector<std::array<int, 3>> faces;
  std::vector<double> bulge;   ///< factor of the source on each face
  std::vector<uint8_t> fixed;  ///< 1 at nodes on the outline
  VectorXd alpha;              ///< 0 at nodes off the outline

  FlatMesh flat() const { return {positions, faces}; }
};

double alpha_of(const BumpNode& node, const LayeredMesh& mesh, const InflationOptions& options) {
  if (node.ramp < 0) return node.t;
  const double given = mesh.ramps[node.ramp].alpha0;
  const double alpha0 = given >= 0 ? given : options.alpha0;
  return alpha0 + (1 - alpha0) * node.t;
}

Bump collect_bump(const SurfaceInput& surface, int part, const std::vector<double>& factors,
                  const InflationOptions& options) {
  const LayeredMesh& mesh = surface.mesh;
  std::vector<int> index(mesh.node_vertex.size(), -1);
  Bump bump;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] != part) continue;
    std::array<int, 3> face{};
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.faces[f][k];
      if (index[n] < 0) {
        index[n] = static_cast<int>(bump.nodes.size());
        bump.nodes.push_back(n);
        bump.positions.push_back(surface.discretisation.scale * mesh.vertices[mesh.node_vertex[n]]);
      }
      face[k] = index[n];
    }
    bump.faces.push_back(face);
    bump.bulge.push_back(factors.empty() ? 1 : factors[f]);
  }
  bump.fixed.assign(bump.nodes.size(), 0);
  bump.alpha = VectorXd::Zero(static_cast<Index>(bump.nodes.size()));
  for (const BumpNode& node : mesh.bump_nodes) {
    if (node.part != part || index[node.node] < 0) continue;
    bump.fixed[index[node.node]] = 1;
    bump.alpha[index[node.node]] = alpha_of(node, mesh, options);
  }
  return bump;
}

/// Solves A x = load with x = `known` on the outline. `known` must be 0 elsewhere.
VectorXd solve_inside(const SparseMatrix& A, const Bump& bump, const VectorXd& known,
                      const VectorXd& load) {
  SparseCholesky factor;
  factor.analyse(A);
  if (!factor.factorise(A, bump.fixed)) return known;
  VectorXd b = load - A * known;
  for (Index i = 0; i < b.size(); ++i)
    if (bump.fixed[i] != 0) b[i] = 0;
  return known + factor.solve(b);
}

/// Computes w at the nodes of the bump, scene units.
VectorXd rise_of(const Bump& bump, const Part& part, double scale) {
  const FlatMesh flat = bump.flat();
  const SparseMatrix L = stiffness_matrix(flat);
  const VectorXd mass = lumped_mass(flat);
  const VectorXd psi = solve_inside(L, bump, bump.alpha, VectorXd::Zero(mass.size()));
  SparseMatrix A = L;
  A.diagonal() += screening_density(part, scale) * mass;
  const VectorXd v = solve_inside(A, bump, VectorXd::Zero(mass.size()),
                                  source_density(part) * load_vector(flat, bump.bulge));
  VectorXd w(v.size());
  for (Index i = 0; i < w.size(); ++i) {
    const double eased = std::clamp(psi[i], 0.0, 1.0);
    w[i] = signed_root(v[i] * eased * eased * eased);
  }
  return w;
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

void raise_bumps(const SurfaceInput& surface, const InflationOptions& options,
                 Inflation& inflation) {
  const std::vector<BumpNode>& outline = surface.mesh.bump_nodes;
  if (outline.empty()) return;
  const double scale = surface.discretisation.scale;
  const std::vector<double> factors = bulge_factors(surface.mesh, surface.scene);
  for (size_t i = 0; i < outline.size(); ++i) {
    if (i > 0 && outline[i].part == outline[i - 1].part) continue;
    const Bump bump = collect_bump(surface, outline[i].part, factors, options);
    const VectorXd w = rise_of(bump, surface.scene.parts[outline[i].part], scale);
    for (size_t k = 0; k < bump.nodes.size(); ++k) {
      double& u = inflation.u[bump.nodes[k]];
      const double f = signed_root(u) + w[static_cast<Index>(k)] / scale;
      u = f * std::abs(f);
    }
  }
  inflation.grad_u = node_gradients(surface.discretisation.gradients, inflation.u);
}

}  // namespace relievo::relief
