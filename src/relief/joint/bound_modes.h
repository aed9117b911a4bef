#pragma once

#include <Eigen/Core>

namespace relievo {

/// Changes of f on B against which the energy is softer or stiffer than the matrix K of the steps.
struct BoundModes {
  Eigen::MatrixXd forces;     ///< #B x modes: K times the changes, which are orthonormal by K
  Eigen::VectorXd stiffness;  ///< of the energy, relative to K, > 0
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

/// J - K by these modes, #B x #B. O(#B^2 modes).
Eigen::MatrixXd missing_stiffness(const BoundModes& modes);

}  // namespace relievo
