#pragma once

#include <optional>
#include <string_view>

#include "relievo/point.h"

namespace relievo {

/// x' = a x + c y + e, y' = b x + d y + f.
struct Affine2 {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  Point2 operator()(Point2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

  /// Factor by which lengths grow on average: the root of the area factor.
  double mean_scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

/// First `inner`, then `outer`.
Affine2 operator*(const Affine2& outer, const Affine2& inner);

inline Affine2 translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
inline Affine2 scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

/// A list of matrix, translate, scale, rotate, skewX and skewY; nothing where it is malformed.
std::optional<Affine2> parse_transform(std::string_view text);

}  // namespace relievo
