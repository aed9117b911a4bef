#include "relief/joint/bound_modes.h"

#include <Eigen/Eigenvalues>
#include <vector>

namespace relievo {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Modes with a relative stiffness between these are left to the mixing.
constexpr double soft_mode = 0.8;
constexpr double stiff_mode = 1.2;
/// One that is softer still is not trusted.
constexpr double softest_mode = 0.05;

bool is_slow(double stiffness) {
  return stiffness > softest_mode && (stiffness < soft_mode || stiffness > stiff_mode);
}

}  // namespace

BoundModes modes_of(const BoundProbes& probes) {
  BoundModes modes;
  if (probes.changes.cols() == 0) return modes;
  const MatrixXd J = probes.changes.transpose() * probes.slopes;
  const MatrixXd K = probes.changes.transpose() * probes.steps;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver((J + J.transpose()) / 2,
                                                                  (K + K.transpose()) / 2);
  if (solver.info() != Eigen::Success) return modes;
  std::vector<Index> slow;
  for (Index k = 0; k < J.cols(); ++k)
    if (is_slow(solver.eigenvalues()[k])) slow.push_back(k);
  modes.forces = probes.steps * solver.eigenvectors()(Eigen::all, slow);
  modes.stiffness = solver.eigenvalues()(slow);
  return modes;
}

MatrixXd missing_stiffness(const BoundModes& modes) {
  const VectorXd missing = modes.stiffness.array() - 1;
  return modes.forces * missing.asDiagonal() * modes.forces.transpose();
}

}  // namespace relievo
