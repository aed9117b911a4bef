#include "relief/model/rim_levels.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

// Rounding must not turn a span of one level into two pieces of half a level: neighbouring chains
// of cuts advance in step only because pieces of a cut edge are longer than half a level.
int piece_count(double span) {
  const double slack = 1e-9;
  return static_cast<int>(std::clamp(std::ceil(span - slack), 1.0, 1e6));
}

bool changes_sign(double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

}  // namespace

RimLevels::RimLevels(double tolerance) : tau_(15.0 / 16 * tolerance), flat_(tolerance / 32) {}

double RimLevels::level(double u) const {
  const double f = std::sqrt(std::abs(u));
  if (f <= flat_) return 0;
  return std::copysign(0.5 * (std::sqrt(1 + 2 * f / tau_) - 1), u);
}

double RimLevels::height(double level) const { return 2 * tau_ * level * (std::abs(level) + 1); }

int cut_count(double first, double last) {
  if (changes_sign(first, last))
    return piece_count(std::abs(first)) + piece_count(std::abs(last)) - 1;
  return piece_count(std::abs(last - first)) - 1;
}

double cut_level(double first, double last, int i) {
  if (!changes_sign(first, last)) {
    const int pieces = piece_count(std::abs(last - first));
    return first + (last - first) * (i + 1) / pieces;
  }
  const int before = piece_count(std::abs(first));
  if (i < before) return first * (before - 1 - i) / before;
  return last * (i + 1 - before) / piece_count(std::abs(last));
}

}  // namespace relievo
