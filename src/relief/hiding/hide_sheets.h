#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/cholesky/sparse_cholesky.h"
#include "kernel/operators/gradient.h"
#include "relief/discretisation/discretisation.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Two faces of one base triangle. The lower one must not lie in front of the upper one.
struct FacePair {
  int lower = -1;
  int upper = -1;
};

/// Pairs each face with the next one in front of it, skipping parts that a relation "free" without
/// a range lets cross. Sorted by base triangle, front to back. O(F) without such relations.
std::vector<FacePair> stacked_faces(const LayeredMesh& mesh, const Scene& scene);

/// Pairs each hidden face with the frontmost one at its base triangle, except where a relation
/// "free" without a range lets them cross. Sorted by base triangle. O(F).
std::vector<FacePair> covered_faces(const LayeredMesh& mesh, const Scene& scene);

/// The distance by which a lower face comes out in front of an upper one at a point.
struct Dip {
  double depth = 0;                ///< px, negative if it stays behind
  std::array<double, 3> weight{};  ///< barycentric coordinates of the point
};

/// Returns the largest dip at six inner points. Interpolates u and g and then takes the root of u.
Dip worst_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
              const Ordering& ordering);

/// Returns the largest dip near corners and edges, px. Beside an outline a root rises more steeply
/// than any face.
double rim_dip(const LayeredMesh& mesh, const FacePair& pair, const Inflation& inflation,
               const Ordering& ordering);

/// The flaps of a mesh and the matrix of the nodes inside them, kept from one call of hide_sheets
/// to the next.
class FlapSystem {
 public:
  /// O(N + faces), and an analysis of the flaps' nodes. If `context` is cancelled, the system must
  /// not be used.
  FlapSystem(const LayeredMesh& mesh, const Discretisation& discretisation,
             const RunContext& context);

  /// Sets u and g inside flaps: u solves the Poisson problem of its part, and g is harmonic. Both
  /// have the values of the nodes at the flaps' edges and are free along the cut at the join. One
  /// factorisation each.
  void fill(const SurfaceInput& surface, const RunContext& context, Inflation& inflation,
            Ordering& ordering);

  /// Sets the gradients of g inside flaps.
  void set_gradients(Ordering& ordering) const;

 private:
  bool solve(const Eigen::VectorXd& load, const std::vector<uint8_t>& fixed,
             const RunContext& context, std::vector<double>& values);

  std::vector<Point2> positions_;          ///< #N, px
  std::vector<int> flaps_;                 ///< faces of the mesh
  std::vector<std::array<int, 3>> faces_;  ///< nodes of each flap
  std::vector<int> nodes_;                 ///< nodes inside flaps, ascending
  GradientStencils gradients_;             ///< on the flaps alone, 1 / px
  SparseMatrix L_;                         ///< #N x #N
  SparseMatrix K_;                         ///< L on nodes_, lower triangle
  SparseCholesky factor_;
};

/// Brings hidden sheets below the visible surface, which does not change. Continues flaps from the
/// edges where their sheet is cut, and lowers hidden nodes that lie in front, also for faces that
/// cross between nodes. Adds `lowered`, `crossing` and the overlaps to `ordering`. Only models with
/// hidden surfaces need it. `flaps`: nothing, or left by a call with the same mesh and
/// discretisation. If `context` is cancelled, the results must not be used. O(F), and a
/// factorisation of the flaps.
void hide_sheets(const SurfaceInput& surface, std::optional<FlapSystem>& flaps,
                 Inflation& inflation, Ordering& ordering, const RunContext& context = {});

}  // namespace relievo::relief
