#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/geometry/polygon.h"
#include "kernel/geometry/triangles.h"
#include "kernel/operators/gradient.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// What holds u on a surface; B has no unit.
struct PoissonBoundary {
  std::vector<uint8_t> fixed;  ///< #N flags: u = 0
  Eigen::VectorXd spring;      ///< #N, to 0: the diagonal of B
  std::vector<double> link;    ///< per ramp node of the mesh, to the node below, where there is one

  friend bool operator==(const PoissonBoundary& a, const PoissonBoundary& b) {
    return a.fixed == b.fixed && a.spring == b.spring && a.link == b.link;
  }
};

/// The Poisson problem of a surface, whose matrix is analysed once and factorised again only as far
/// as its boundary conditions change.
class PoissonSystem {
 public:
  /// Unknowns are the nodes of shaping faces that are not on outlines, in the discretisation's
  /// order. Systems that
  /// are to be solved with several boundary conditions are best incremental. Where `context` is
  /// cancelled the system is of no use.
  PoissonSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
                Refactorisation refactorisation, const RunContext& context);

  /// Solves (L + B) u = load with u = 0 on outlines and where it is fixed. Nothing where there is
  /// no finite solution or `context` is cancelled.
  std::optional<Eigen::VectorXd> solve(const PoissonBoundary& boundary, const Eigen::VectorXd& load,
                                       const RunContext& context);

 private:
  /// Two unknowns at one place that may be linked.
  struct Link {
    int ramp_node = -1;  ///< of the mesh
    int row = -1;
    int column = -1;  ///< < row
  };

  void collect_links(const LayeredMesh& mesh);
  void set_values(const PoissonBoundary& boundary);

  std::vector<int> unknown_;  ///< #N, -1 on outlines and inside flaps
  std::vector<int> node_;     ///< of each unknown
  std::vector<Link> links_;
  SparseMatrix L_;  ///< of the unknowns, lower triangle, with zeros for links
  SparseMatrix A_;  ///< with the boundary of the factor
  SparseCholesky factor_;
  std::optional<PoissonBoundary> last_;  ///< in the factor, if there is one
};

/// -div grad u + screening u = density within a part, in scene units.
struct PartSource {
  double density = 0;
  double screening = 0;
};

/// That of c, d and flat. `scale`: scene units per px. O(points of the outline).
PartSource source_of(const Part& part, double scale);

/// The right-hand side and the zeroth-order term of L u + screening u = load.
struct InflationTerms {
  Eigen::VectorXd load;       ///< #N, integral of b^2 c d|d| against each node's hat function
  Eigen::VectorXd screening;  ///< #N, diagonal; 0 where parts are not flat
};

/// Both in units of 1 / `scale` px. A flat part has the source and the screening of
///   -div grad u + (k/w)^2 u = c d|d| k^2 / (2 - 2 / cosh k),   k = 8 flat,
/// w = area / perimeter of its outline: a strip, whose half-width w is, keeps its height, and u is
/// even but for a border of width w/k. Bulges multiply the source with b^2 (bulge_factors).
/// O(N + F + points) without any.
InflationTerms inflation_terms(const LayeredMesh& mesh, const Scene& scene, double scale);

/// The sign that u has by the maximum principle, #N: 1 or -1 where all parts of the node's surface
/// have d of that sign, 0 where they differ. `surface` is the one of each node, #N. O(N + F).
std::vector<int> surface_signs(const LayeredMesh& mesh, const std::vector<int>& surface,
                               const Scene& scene);

/// u in px^2 and its gradients, from u in units of 1 / `scale` px. O(entries of the stencils).
Inflation make_inflation(const GradientStencils& gradients, const Eigen::VectorXd& u, double scale);

}  // namespace relievo::relief
