#include "relief/joint/bound_modes.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index bound_nodes = 40;

/// As steps have it: tridiagonal, definite.
MatrixXd step_matrix() {
  MatrixXd K = 2.5 * MatrixXd::Identity(bound_nodes, bound_nodes);
  for (Index i = 0; i + 1 < bound_nodes; ++i) K(i, i + 1) = K(i + 1, i) = -1;
  return K;
}

/// Forces at some nodes, which the matrix of the steps answers too much or too little.
MatrixXd forces_at(const std::vector<int>& nodes) {
  MatrixXd forces = MatrixXd::Zero(bound_nodes, static_cast<Index>(nodes.size()));
  for (size_t k = 0; k < nodes.size(); ++k) forces(nodes[k], static_cast<Index>(k)) = 1;
  return forces;
}

BoundProbes probes_of(const MatrixXd& K, const MatrixXd& J, const MatrixXd& forces) {
  const MatrixXd changes = K.ldlt().solve(forces);
  return {changes, K * changes, J * changes};
}

TEST(BoundModes, AreOrthonormalAndDiagonaliseTheEnergy) {
  const MatrixXd K = step_matrix();
  const MatrixXd forces = forces_at({0, 3, 20, 39});
  const Eigen::Vector4d softening(1, 1.2, -2, 1.5);
  const MatrixXd J = K - forces * softening.asDiagonal() * forces.transpose();
  const BoundModes modes = modes_of(probes_of(K, J, forces));
  ASSERT_EQ(modes.stiffness.size(), 4);
  const MatrixXd changes = K.ldlt().solve(modes.forces);
  EXPECT_LE((changes.transpose() * modes.forces - MatrixXd::Identity(4, 4)).norm(), 1e-12);
  const MatrixXd rest = J * changes - modes.forces * modes.stiffness.asDiagonal();
  EXPECT_LE(rest.norm(), 1e-12);
}

TEST(BoundModes, TellWhatIsMissingFromTheEnergyItself) {
  const MatrixXd K = step_matrix();
  const MatrixXd forces = forces_at({0, 3, 20});
  const Eigen::Vector3d softening(1, 1.2, -2);
  const MatrixXd missing = -forces * softening.asDiagonal() * forces.transpose();
  const BoundModes modes = modes_of(probes_of(K, K + missing, forces));
  EXPECT_LE((missing_stiffness(modes) - missing).norm(), 1e-12);
}

TEST(BoundModes, LeaveOutWhatTheStepsKnowAndWhatHasNoMinimum) {
  const MatrixXd K = step_matrix();
  const MatrixXd forces = forces_at({0, 20});
  const Eigen::Vector2d softening(0.1, 4);
  const MatrixXd J = K - forces * softening.asDiagonal() * forces.transpose();
  EXPECT_EQ(modes_of(probes_of(K, J, forces)).stiffness.size(), 0);
  EXPECT_EQ(modes_of({}).stiffness.size(), 0);
  EXPECT_EQ(missing_stiffness(modes_of(probes_of(K, J, forces))),
            MatrixXd::Zero(bound_nodes, bound_nodes));
}

}  // namespace
}  // namespace relievo
