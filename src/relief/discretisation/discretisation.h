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

/// Gradients at the corners of faces beside creases, from values of nodes on their own side only.
struct CreaseStencils {
  std::vector<Corner> corner;  ///< ascending: at nodes of creases and their neighbours
  std::vector<int> place;      ///< of each of them, its place in `node`
  std::vector<int> node;       ///< of the mesh; one that has two sides occurs for each of them
  GradientStencils gradients;  ///< between places, 1 / px
};

/// Empty where the mesh has no crease. O(F + length of creases).
CreaseStencils crease_stencils(const LayeredMesh& mesh);

/// Gradients at the corners of the stencils, of a function with these values at the nodes.
std::vector<Point2> crease_gradients(const CreaseStencils& stencils,
                                     const std::vector<double>& values);

/// The joined surface as the solvers see it: what its triangulation alone decides, and all stages
/// share.
struct Discretisation {
  double scale = 1;              ///< scene units per px
  SparseMatrix L;                ///< #N x #N, stiffness, both triangles; without flaps
  std::vector<int> surface;      ///< #N, smallest node of the node's joined surface
  Eigen::VectorXd mass;          ///< #N, lumped, scene units^2; 0 inside flaps
  GradientStencils gradients;    ///< at nodes, 1 / px; none inside flaps
  CreaseStencils creases;        ///< at corners beside creases
  std::vector<int> elimination;  ///< nodes in an order in which matrices on them fill in little;
                                 ///< those at one base vertex are consecutive
};

/// Assembles the operators of the joined surface and orders its nodes for elimination. Reads the
/// triangulation, the nodes and the flaps of the mesh, not its roles nor the constraints. Where
/// `context` is cancelled the result is of no use. O(N log N).
Discretisation discretise(const LayeredMesh& mesh, const RunContext& context = {});

/// The input that all solvers of a joined surface share: its mesh, the operators on it, and the
/// scene that it shows.
struct SurfaceInput {
  const LayeredMesh& mesh;
  const Discretisation& discretisation;
  const Scene& scene;
};

}  // namespace relievo::relief
