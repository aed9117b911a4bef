#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "kernel/geometry/triangles.h"

namespace relievo {

/// The discrete harmonic functions with the given values (#V x any number of columns, of which
/// other rows are not read) where `fixed` (#V flags), and no flow through the rest of the boundary.
/// `otherwise` on pieces of the mesh without a fixed vertex. One factorisation.
Eigen::MatrixXd harmonic_extension(const FlatMesh& mesh, std::vector<uint8_t> fixed,
                                   Eigen::MatrixXd values, double otherwise);

/// The function whose gradient is nearest to a field that is constant on each triangle (#F), in the
/// mean square; its mean is 0 on every piece of the mesh. #V. One factorisation.
Eigen::VectorXd nearest_potential(const FlatMesh& mesh, const std::vector<Point2>& field);

}  // namespace relievo
