#pragma once

#include <Eigen/Core>

namespace relievo {

/// Changes of f on B against which the energy is softer or stiffer than the matrix K of the steps.
struct BoundModes {
  Eigen::MatrixXd values;     ///< #B x modes, orthonormal by K
  Eigen::VectorXd stiffness;  ///< of the energy, relative to K, > 0

  bool empty() const { return stiffness.size() == 0; }
};

/// Some changes of f on B, how K answers to them, and how the slope of the energy does.
struct BoundProbes {
  Eigen::MatrixXd changes;  ///< #B x probes
  Eigen::MatrixXd steps;    ///< K changes
  Eigen::MatrixXd slopes;   ///< J changes, J the second derivative of the energy / 2
};

/// The modes in the span of the probes for which J and K differ by much (Rayleigh and Ritz).
/// Precondition: the changes are independent. O(#B probes^2 + probes^3).
BoundModes modes_of(const BoundProbes& probes);

/// What J^-1 force has beyond K^-1 force, by these modes. O(#B modes).
Eigen::VectorXd correction(const BoundModes& modes, const Eigen::VectorXd& force);

}  // namespace relievo
