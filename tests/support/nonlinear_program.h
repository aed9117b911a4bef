#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/nonlinear/solve_nonlinear.h"
#include "relief/ordering/ordering.h"
#include "relievo/scene.h"

namespace relievo::testing {

/// The non-linear problem as a general non-linear program, put together from the operators alone.
/// Scene units. The unknowns p are |u| at free nodes and |f| on B, both >= 0, and g at all nodes.
/// Surfaces have one sign each.
struct NonlinearProgram {
  double scale = 1;  ///< scene units per px
  double lambda_bnd = 1;
  double lambda_shift = 1;
  Eigen::SparseMatrix<double> L;
  Eigen::SparseMatrix<double> A;  ///< L + epsilon M
  Eigen::VectorXd mass;
  Eigen::VectorXd load;
  Eigen::VectorXd pull;                  ///< #N, of leaning parts on the shift
  double lean_constant = 0;              ///< of the shift's cost
  Eigen::VectorXd sign;                  ///< #N, of u
  Eigen::VectorXd bound_mass;            ///< #N, 0 off B
  Eigen::VectorXd held;                  ///< #N, u where it is held, 0 elsewhere
  std::vector<int> row;                  ///< #N: unknown of the node, -1 where it is held
  std::vector<int> node;                 ///< of each unknown
  std::vector<relief::DepthPair> pairs;  ///< that are enforced
};

/// A point of the program.
struct NonlinearPoint {
  Eigen::VectorXd p;  ///< one per unknown
  Eigen::VectorXd g;  ///< #N
};

/// B are the nodes under ranges that are glued or that pairs may lift. The others, and free nodes
/// with u = 0, are held at the u of `inflation`.
NonlinearProgram make_nonlinear_program(const relief::LayeredMesh& mesh, const Scene& scene,
                                        const relief::NonlinearOptions& options,
                                        const relief::Inflation& inflation);

/// Whether every surface inflates in one direction.
bool has_pure_surfaces(const relief::LayeredMesh& mesh, const Scene& scene);

NonlinearPoint point_of(const NonlinearProgram& program, const relief::Inflation& inflation,
                        const relief::Ordering& ordering);

bool on_bound(const NonlinearProgram& program, int unknown);

/// u at all nodes.
Eigen::VectorXd squares(const NonlinearProgram& program, const Eigen::VectorXd& p);

double energy(const NonlinearProgram& program, const NonlinearPoint& point);

/// Derivatives of the energy.
NonlinearPoint gradient(const NonlinearProgram& program, const NonlinearPoint& point);

/// f + g at all nodes.
Eigen::VectorXd heights(const NonlinearProgram& program, const NonlinearPoint& point);

/// Derivative of f at the node of an unknown.
double root_slope(const NonlinearProgram& program, const NonlinearPoint& point, int unknown);

/// Worst violation of the pairs.
double violation(const NonlinearProgram& program, const NonlinearPoint& point);

}  // namespace relievo::testing
