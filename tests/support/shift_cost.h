#pragma once

#include <Eigen/Core>

#include "kernel/geometry/polygon.h"
#include "relief/layers/layered_mesh.h"
#include "relievo/scene.h"

namespace relievo::testing {

/// What a shift costs by the definition, face by face and without any matrix: scene units.
struct ShiftCost {
  const relief::LayeredMesh& mesh;
  const Scene& scene;
  double epsilon = 0;

  /// 1/2 sum over parts of integral |grad g - t|^2 + epsilon |g - r|^2, t the lean of the part and
  /// r = t . x + const, masses lumped. The constants are those of least squares of the differences
  /// between two parts' r where one is next to the other in the stack, and a little of r itself.
  /// g: #N.
  double operator()(const Eigen::VectorXd& g) const;

  /// Its derivatives, #N, by differences, which are exact as the cost is quadratic.
  Eigen::VectorXd slope(const Eigen::VectorXd& g) const;
};

}  // namespace relievo::testing
