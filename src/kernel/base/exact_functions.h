#pragma once

#include "relievo/point.h"

namespace relievo {

/// Elementary functions that use nothing but +, -, *, / and square roots, which IEEE 754 rounds
/// correctly. The functions of C libraries differ in their last digit. These return the same bits
/// on every machine and in the browser, so that a drawing is understood in the same way everywhere.
/// For finite arguments the relative error is below 1e-15; angles, and sines near their zeros, have
/// an absolute error below 1e-15.
namespace exact {

/// Returns the unit vector (cos angle, sin angle); `angle` is in radians. Precondition:
/// |angle| < 1e6.
Point2 direction_of(double angle);

/// Returns atan2(y, x) in radians, in (-pi, pi]; 0 at the origin.
double angle_of(double y, double x);

/// Returns e^x; 0 for x < -700, and e^700 for x > 700.
double exp(double x);

/// Returns the natural logarithm. Precondition: x > 0, not subnormal.
double log(double x);

}  // namespace exact
}  // namespace relievo
