#pragma once

namespace relievo {

/// Elementary functions of the four operations and roots alone. C libraries round the last digit of
/// theirs as they like; these give the same bits on every machine and in the browser, so that what
/// is guessed of a drawing is guessed everywhere. Relative errors are below 1e-15 (absolute ones
/// of angles, and of sines beside their zeros) for finite arguments.
namespace exact {

struct Direction {
  double cosine = 1;
  double sine = 0;
};

/// Precondition: |angle| < 1e6.
Direction direction_of(double angle);

/// In (-pi, pi]; 0 at the origin.
double angle_of(double y, double x);

/// 0 below -700; above 700 as there.
double exp(double x);

/// Precondition: x > 0, not subnormal.
double log(double x);

}  // namespace exact
}  // namespace relievo
