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

/// The faces of one bump with its nodes numbered.
struct Bump {
  std::vector<int> nodes;  ///< of the mesh
  std::vector<Point2> positions;
  std::vector<std::array<int, 3>> faces;
  std::vector<double> bulge;   ///< factor of the source on each face
  std::vector<uint8_t> fixed;  ///< on the outline
  VectorXd alpha;              ///< there; 0 elsewhere

  FlatMesh flat() const { return {positions, faces}; }
};

double alpha_of(const BumpNode& node, const LayeredMesh& mesh, const InflationOptions& options) {
  if (node.ramp < 0) return node.t;
  const double given = mesh.ramps[node.ramp].alpha0;
  const double alpha0 = given >= 0 ? given : options.alpha0;
  return alpha0 + (1 - alpha0) * node.t;
}

Bump collect_bump(const InflationInput& input, int part, const std::vector<double>& factors,
                  const InflationOptions& options) {
  const LayeredMesh& mesh = input.mesh;
  std::vector<int> place(mesh.node_vertex.size(), -1);
  Bump bump;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_part[f] != part) continue;
    std::array<int, 3> face{};
    for (int k = 0; k < 3; ++k) {
      const int n = mesh.faces[f][k];
      if (place[n] < 0) {
        place[n] = static_cast<int>(bump.nodes.size());
        bump.nodes.push_back(n);
        bump.positions.push_back(input.discretisation.scale * mesh.vertices[mesh.node_vertex[n]]);
      }
      face[k] = place[n];
    }
    bump.faces.push_back(face);
    bump.bulge.push_back(factors.empty() ? 1 : factors[f]);
  }
  bump.fixed.assign(bump.nodes.size(), 0);
  bump.alpha = VectorXd::Zero(static_cast<Index>(bump.nodes.size()));
  for (const BumpNode& node : mesh.bump_nodes) {
    if (node.part != part || place[node.node] < 0) continue;
    bump.fixed[place[node.node]] = 1;
    bump.alpha[place[node.node]] = alpha_of(node, mesh, options);
  }
  return bump;
}

SparseMatrix lower_triangle(const SparseMatrix& A) { return A.triangularView<Eigen::Lower>(); }

/// Solves A x = load with x = `known` where fixed.
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

/// w at the nodes of the bump, scene units.
VectorXd rise_of(const Bump& bump, const PartSource& source) {
  const FlatMesh flat = bump.flat();
  const SparseMatrix L = stiffness_matrix(flat);
  const VectorXd mass = lumped_mass(flat);
  const VectorXd psi = solve_inside(L, bump, bump.alpha, VectorXd::Zero(mass.size()));
  SparseMatrix A = L;
  A.diagonal() += source.screening * mass;
  const VectorXd v = solve_inside(A, bump, VectorXd::Zero(mass.size()),
                                  source.density * load_vector(flat, bump.bulge));
  VectorXd w(v.size());
  for (Index i = 0; i < w.size(); ++i) {
    const double eased = std::clamp(psi[i], 0.0, 1.0);
    w[i] = signed_root(v[i] * eased * eased * eased);
  }
  return w;
}

}  // namespace

void raise_bumps(const InflationInput& input, const InflationOptions& options,
                 Inflation& inflation) {
  const std::vector<BumpNode>& outline = input.mesh.bump_nodes;
  if (outline.empty()) return;
  const double scale = input.discretisation.scale;
  const std::vector<double> factors = bulge_factors(input.mesh, input.scene);
  for (size_t i = 0; i < outline.size(); ++i) {
    if (i > 0 && outline[i].part == outline[i - 1].part) continue;
    const Bump bump = collect_bump(input, outline[i].part, factors, options);
    const VectorXd w = rise_of(bump, source_of(input.scene.parts[outline[i].part], scale));
    for (size_t k = 0; k < bump.nodes.size(); ++k) {
      double& u = inflation.u[bump.nodes[k]];
      const double f = signed_root(u) + w[static_cast<Index>(k)] / scale;
      u = f * std::abs(f);
    }
  }
  inflation.grad_u = node_gradients(input.discretisation.gradients, inflation.u);
}

}  // namespace relievo::relief
