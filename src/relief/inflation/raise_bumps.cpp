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

#include "relief/inflation/raise_bumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/laplacian.h"
#include "relief/cues/cue_fields.h"
#include "relief/inflation/inflate.h"
#include "relief/inflation/poisson_system.h"
#include "relief/layers/layered_mesh.h"

namespace relievo::relief {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

SparseMatrix lower_triangle(const SparseMatrix& A) { return A.triangularView<Eigen::Lower>(); }

/// Solves A x = load with x = `known` on the outline. `known` must be 0 elsewhere.
VectorXd solve_inside(const SparseMatrix& A, const Bump& bump, const VectorXd& known,
                      const VectorXd& load) {
  SparseCholesky factor;
  const SparseMatrix lower = lower_triangle(A);
  factor.analyse(lower);
  if (!factor.factorise(lower, bump.fixed)) return known;
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
