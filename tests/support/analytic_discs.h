#pragma once

#include <vector>

#include "kernel/geometry/polygon.h"
#include "relief/inflation/inflation.h"
#include "relief/layers/layered_mesh.h"
#include "relief/ordering/ordering.h"
#include "relievo/model.h"
#include "relievo/scene.h"

namespace relievo {

/// A part whose heights are known: f = d sqrt(radius^2 - r^2), g = lift + slope . (p - centre).
struct Disc {
  Point2 centre;
  double radius = 1;
  double d = 1;
  double lift = 0;
  Point2 slope{};
};

/// Everything that the model stage reads, filled with exact values at the nodes.
struct DiscRelief {
  Scene scene;
  relief::LayeredMesh mesh;
  relief::Inflation inflation;
  relief::Ordering ordering;
};

double disc_u(const Disc& disc, Point2 p);
double disc_g(const Disc& disc, Point2 p);
double disc_height(const Disc& disc, Point2 p);

/// Discs, back to front, on one conforming triangulation: their circles are cut where they cross.
/// No two circles may touch or coincide, no three may meet.
DiscRelief make_discs(const std::vector<Disc>& discs, double width, double height,
                      double edge_length);

/// Replaces the heights of all nodes by u(p) and g(p), both linear: value + slope . p.
struct LinearField {
  double value = 0;
  Point2 slope;
};
void set_linear_heights(DiscRelief& relief, LinearField u, LinearField g);

/// The model of the discs; a failure fails the test and gives an empty one.
Model assemble(const DiscRelief& relief, const ModelOptions& options);
Model assemble(const DiscRelief& relief, Visibility visibility = Visibility::relief);

}  // namespace relievo
