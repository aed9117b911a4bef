#pragma once

#include <optional>
#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

struct Ellipse {
  Point2 centre;
  double a = 0;  ///< half axes, px
  double b = 0;
  double angle = 0;  ///< of axis a to the x axis, radians, clockwise on the screen
};

/// What an ellipse is fitted to.
struct EllipseEvidence {
  std::vector<Point2> on;       ///< points of the contour
  std::vector<Point2> within;   ///< points that the ellipse should contain
  std::vector<Point2> without;  ///< points that it should not contain
  double noise = 0.7;           ///< standard deviation of `on`, px
};

/// Distance of p from the ellipse to first order, px; negative inside: with r the distance from the
/// centre in half axes, (r - 1) / |grad r| (P. D. Sampson, Fitting conic sections to "very
/// scattered" data, 1982).
double first_order_distance(const Ellipse& ellipse, Point2 p);

/// The most likely ellipse: least squares of the distances of `on` and of what of `within` lies
/// outside and of `without` inside, with a preference for axes not longer than two to one where
/// the evidence leaves the shape open. Nothing where there are fewer than 6 points on it.
/// Levenberg-Marquardt from the moments of all points; O(points) a step, from two starts, at most
/// 25 steps each.
std::optional<Ellipse> fit_ellipse(const EllipseEvidence& evidence);

/// The ellipse as a ring of positive area.
Ring ring_of(const Ellipse& ellipse, int points);

}  // namespace relievo
