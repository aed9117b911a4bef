#pragma once

namespace relievo {

enum class SolveStatus { solved, iteration_limit, not_positive_definite, interrupted };

/// How a bound-constrained quadratic program was solved. Residuals are in the units that the
/// solver was given (scene units), in the maximum norm relative to max(1, |b|).
struct BoundQpReport {
  SolveStatus status = SolveStatus::solved;
  int iterations = 0;
  int factorisations = 0;
  int safeguard_steps = 0;     ///< iterations of the safeguard that ends cycles
  int active = 0;              ///< bounds that hold with equality
  double stationarity = 0;     ///< max |K z - b - mu|
  double primal = 0;           ///< worst violation of z >= 0
  double dual = 0;             ///< worst violation of mu >= 0
  double complementarity = 0;  ///< max |z mu| over the bounds
  double energy = 0;           ///< 1/2 z'Kz - b'z
};

}  // namespace relievo
