#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "kernel/operators/gradient.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Boundary conditions and zeroth-order terms of the Poisson problem, dimensionless.
struct PoissonBoundary {
  std::vector<uint8_t> fixed;    ///< #N flags: u = 0 (Dirichlet)
  Eigen::VectorXd diagonal;      ///< #N, added to the diagonal: Robin terms and screening
  std::vector<double> coupling;  ///< #ramp nodes, stiffness between the node and the one below it

  friend bool operator==(const PoissonBoundary&, const PoissonBoundary&) = default;
};

/// The Poisson problem of a surface. Its matrix is analysed once, and only the part of the factor
/// that depends on changed boundary conditions is computed again.
class PoissonSystem {
 public:
  /// Analyses the matrix. The unknowns are the nodes of shaping faces off outlines, in the
  /// discretisation's order. Choose incremental refactorisation to solve with several boundary
  /// conditions. If `context` is cancelled, the system must not be used.
  PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                Refactorisation refactorisation, const RunContext& context);

  /// Solves (L + B) u = load (#N each) with u = 0 on outlines and where it is fixed. Returns
  /// nothing if there is no finite solution or `context` is cancelled.
  std::optional<Eigen::VectorXd> solve(const PoissonBoundary& boundary, const Eigen::VectorXd& load,
                                       const RunContext& context);

 private:
  /// Checks whether both a ramp node and the node below it are unknowns.
  bool is_coupled(const RampNode& ramp) const;
  void add_couplings();
  void set_values(const PoissonBoundary& boundary);

  std::vector<int> unknown_;  ///< #N: index of the node's unknown, or -1
  std::vector<int> node_;     ///< node of each unknown
  std::vector<RampNode> ramp_nodes_;
  SparseMatrix L_;  ///< on the unknowns, lower triangle, with zeros for the couplings
  SparseMatrix A_;  ///< L + B that was last factorised
  SparseCholesky factor_;
  std::optional<PoissonBoundary> last_;  ///< conditions in the factor, if there is one
};

/// Returns the source of u inside a part: c d|d|, and for a flat part the factor
/// k^2 / (2 - 2 / cosh k) with k = 8 flat. Dimensionless.
double source_density(const Part& part);

/// Returns the coefficient (k / w)^2 of the zeroth-order term that makes a part flat, in 1 / scene
/// unit^2; 0 for round parts. w is area / perimeter of the outline. On a strip, whose half-width w
/// is, the height stays that of a round part, and u is even except in a border of width w / k.
/// `scale`: scene units per px. O(points of the outline).
double screening_density(const Part& part, double scale);

/// Returns the right-hand side M c: the integral of b^2 times the source density against the hat
/// function of each node, #N, in scene units. b is the factor of bulges (bulge_factors). Flaps have
/// no source. O(N + F + points) if there is no bulge.
Eigen::VectorXd inflation_load(const LayeredMesh& mesh, const Scene& scene, double scale);

/// Returns the diagonal K of the screening of flat parts, #N, in scene units. O(N + F + points).
Eigen::VectorXd inflation_screening(const LayeredMesh& mesh, const Scene& scene, double scale);

/// Returns the sign that u has by the maximum principle, #N: 1 or -1 if d has that sign on all
/// parts of the node's surface, otherwise 0. `surface`: #N, the surface of each node. O(N + F).
std::vector<int> surface_signs(const LayeredMesh& mesh, const std::vector<int>& surface,
                               const Scene& scene);

/// Converts u from scene units^2 to px^2 and computes its gradients. O(entries of the stencils).
Inflation make_inflation(const GradientStencils& gradients, const Eigen::VectorXd& u, double scale);

}  // namespace relievo::relief
