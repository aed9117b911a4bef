#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/base/sparse_matrix.h"
#include "kernel/operators/gradient.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/point.h"
#include "relievo/run_context.h"
#include "relievo/scene.h"

namespace relievo::relief {

/// Gradient stencils for the corners of faces beside creases, from values on their own side only.
/// They work on a patch of the mesh that is cut along the creases: its vertices are nodes of the
/// mesh, those on a crease once for each side.
struct CreaseStencils {
  std::vector<Corner> corner;  ///< ascending, those at nodes of creases and at their neighbours
  std::vector<int> vertex;     ///< of the patch, at each of these corners
  std::vector<int> node;       ///< of the mesh, at each vertex of the patch
  GradientStencils gradients;  ///< at the vertices of the patch, 1 / px
};

/// Makes the stencils beside the creases of the mesh; empty if it has none. O(F + length of
/// creases).
CreaseStencils crease_stencils(const LayeredMesh& mesh);

/// Computes the gradients, at the corners of the stencils, of the function with the given values at
/// nodes.
std::vector<Point2> crease_gradients(const CreaseStencils& stencils,
                                     const std::vector<double>& values);

/// The operators of the joined surface, on which inflation and ordering work [P eq 12]:
///   L_ij = integral of grad phi_i . grad phi_j,   M_ii = integral of phi_i,
/// with the hat functions phi_i of the flat joined mesh in scene units. Flaps take no part.
struct Discretisation {
  double scale = 1;              ///< scene units per px
  SparseMatrix L;                ///< #N x #N stiffness, both triangles stored
  std::vector<int> surface;      ///< #N, smallest node of the node's joined surface
  Eigen::VectorXd mass;          ///< #N, diagonal of M, scene units^2; 0 inside flaps
  GradientStencils gradients;    ///< at nodes, 1 / px; none inside flaps
  CreaseStencils creases;        ///< at corners beside creases
  std::vector<int> elimination;  ///< nodes in an order with little fill-in for matrices on them;
                                 ///< those at one base vertex are consecutive
};

/// Assembles the operators and orders the nodes for elimination. Reads the triangulation, nodes,
/// creases and flaps of the mesh, not its roles or constraints. If `context` is cancelled the
/// result is incomplete. O(N log N).
Discretisation discretise(const LayeredMesh& mesh, const RunContext& context = {});

/// The input that all solvers of a joined surface share: its mesh, the operators on it, and the
/// scene that it shows.
struct SurfaceInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
};

}  // namespace relievo::relief
