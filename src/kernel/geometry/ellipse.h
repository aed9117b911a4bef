#pragma once

#include <optional>
#include <vector>

#include "kernel/geometry/polygon.h"

namespace relievo {

/// An ellipse in the plane.
struct Ellipse {
  Point2 centre;
  double a = 0;      ///< half axis along `angle`, px
  double b = 0;      ///< half axis across it, px
  double angle = 0;  ///< from the x axis to axis a, radians, clockwise on the screen
};

/// The points that an ellipse is fitted to.
struct EllipseEvidence {
  std::vector<Point2> on;       ///< points of the contour
  std::vector<Point2> within;   ///< points that the ellipse should contain
  std::vector<Point2> without;  ///< points that it should not contain
  double noise = 0.7;           ///< standard deviation of `on`, px
};

/// Computes the distance of p from the ellipse to first order, px, negative inside:
/// (r - 1) / |grad r|, where r is the distance from the centre in half axes (P. D. Sampson, Fitting
/// conic sections to "very scattered" data, 1982).
double first_order_distance(const Ellipse& ellipse, Point2 p);

/// Fits the most likely ellipse. Minimises the sum of the squared distances of the points `on`, of
/// those `within` that lie outside, and of those `without` that lie inside. Where the evidence
/// leaves the shape open, prefers axes of at most two to one. Returns nothing where `on` has fewer
/// than 6 points. Levenberg-Marquardt from two starts, the moments of all points and a circle, with
/// at most 25 steps each; O(points) a step.
std::optional<Ellipse> fit_ellipse(const EllipseEvidence& evidence);

/// Returns the ellipse as a ring of positive area with so many points.
Ring ring_of(const Ellipse& ellipse, int points);

}  // namespace relievo
