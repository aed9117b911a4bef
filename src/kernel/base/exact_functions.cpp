#include "kernel/base/exact_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo::exact {
namespace {

/// pi / 2 and log 2, each as a sum of two numbers: whole multiples of the first one are exact.
constexpr double quarter = 1.57079632673412561417e+00;
constexpr double quarter_rest = 6.07710050650619224932e-11;
constexpr double ln2 = 6.93147180369123816490e-01;
constexpr double ln2_rest = 1.90821492927058770002e-10;
constexpr double largest_exponent = 700;

/// Computes the sum of (-1)^k x^2k / ((first + 1) ... (first + 2 k)) for k < terms, the series of
/// sin(x) / x (first = 1) and cos(x) (first = 0).
double alternating_series(double x2, int first, int terms) {
  double sum = 1;
  for (int k = terms - 1; k >= 1; --k) {
    const double n = first + 2.0 * k;
    sum = 1 - sum * x2 / (n * (n - 1));
  }
  return sum;
}

/// Computes the sum of (-x^2)^k / (2 k + 1) for k < terms, the series of atan(x) / x.
double atan_series(double x2, int terms) {
  double sum = 0;
  for (int k = terms - 1; k >= 0; --k) sum = 1.0 / (2 * k + 1) - sum * x2;
  return sum;
}

/// Computes atan(x) for x in [0, 1]. The angle is halved twice, to at most pi / 16.
double small_angle(double x) {
  const double half = x / (1 + std::sqrt(1 + x * x));
  const double fourth = half / (1 + std::sqrt(1 + half * half));
  return 4 * fourth * atan_series(fourth * fourth, 13);
}

}  // namespace

Point2 direction_of(double angle) {
  const double turns = std::nearbyint(angle / (quarter + quarter_rest));
  const double r = (angle - turns * quarter) - turns * quarter_rest;
  const double s = r * alternating_series(r * r, 1, 10);
  const double c = alternating_series(r * r, 0, 10);
  const auto at = static_cast<int>(turns - 4 * std::floor(turns / 4));
  if (at == 0) return {c, s};
  if (at == 1) return {-s, c};
  if (at == 2) return {-c, -s};
  return {s, -c};
}

double angle_of(double y, double x) {
  const double u = std::abs(x);
  const double v = std::abs(y);
  if (u == 0 && v == 0) return 0;
  double angle = v <= u ? small_angle(v / u) : std::numbers::pi / 2 - small_angle(u / v);
  if (x < 0) angle = std::numbers::pi - angle;
  return y < 0 ? -angle : angle;
}

double exp(double x) {
  if (x < -largest_exponent) return 0;
  x = std::min(x, largest_exponent);
  const double power = std::nearbyint(x / (ln2 + ln2_rest));
  const double r = (x - power * ln2) - power * ln2_rest;
  double sum = 1;
  for (int k = 14; k >= 1; --k) sum = 1 + sum * r / k;
  return std::ldexp(sum, static_cast<int>(power));
}

double log(double x) {
  int power = 0;
  double m = std::frexp(x, &power);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --power;
  }
  const double s = (m - 1) / (m + 1);
  // The series of atanh is the one of atan without the alternating signs.
  return power * ln2 + (2 * s * atan_series(-s * s, 12) + power * ln2_rest);
}

}  // namespace relievo::exact
