#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"
#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo {

/// How an outline is traced. Waves of an outline shorter than `wavelength` are smoothed out, by
/// moves of at most `reach` in x and in y; both are reduced for thin masks.
struct OutlineOptions {
  int min_sides = 12;       ///< rings with fewer pixel sides are dropped
  double wavelength = 40;   ///< pixel sides; 0: no smoothing
  double reach = 1;         ///< px, > 0
  double tolerance = 0.02;  ///< distance by which simplification may move the outline, px
};

/// Computes the sub-pixel outline of a mask in canvas px: fair curves near the middles of its pixel
/// sides, as smooth as lines drawn by hand, which move no middle by more than `reach`, so that
/// corners stay. Outer rings have positive area, holes negative. The longest ring is kept whatever
/// its size. O(box + boundary * log boundary).
Outline outline_of(const Mask& mask, const OutlineOptions& options = {});

/// Computes the box around the pixels of a mask (one channel) that are not 0, px; empty where there
/// is none. O(pixels).
Box2 box_of(const Image8& mask);

/// Returns the pixels of a width x height canvas whose centres are inside the outline by the
/// non-zero rule. O(points + crossed rows + box).
Mask fill_outline(const Outline& outline, int width, int height);

/// A closed boundary of a label along pixel sides. The label lies to the right of the direction of
/// travel: outer rings run clockwise on the screen, holes anticlockwise.
struct LabelRing {
  uint16_t label = 0;
  std::vector<Point2> sides;     ///< middle of every pixel side, canvas px
  std::vector<uint16_t> beyond;  ///< label across each side; 0 also outside the image
  bool hole = false;

  size_t size() const { return sides.size(); }
};

/// Traces the rings of all labels but 0, in the raster order of their first sides. Labels are
/// 4-connected: two pixels of a label that touch only at a corner have separate rings. O(pixels).
std::vector<LabelRing> trace_label_rings(const Image16& labels);

/// A point on a label's ring where three labels meet, since the label beyond the ring changes.
struct Junction {
  size_t at = 0;        ///< first side of the ring after it
  uint16_t before = 0;  ///< label beyond the ring before it
  uint16_t after = 0;   ///< label beyond the ring after it
  Point2 in;            ///< direction of the ring before it, px; zero where too few sides count
  Point2 out;           ///< direction of the ring after it, likewise
};

/// Finds the junctions of a ring, in its order. A direction is a chord of up to 11 sides that
/// begins 3 sides from the junction, since the width of drawn lines displaces what is nearer.
/// O(sides + junctions).
std::vector<Junction> find_junctions(const LabelRing& ring);

/// Computes the confidence that the ring's label hides the two others at a T-junction, in [0, 1]:
/// it is larger the straighter the ring runs through the junction, and 0 where a direction is
/// missing.
double t_junction_confidence(const Junction& junction);

}  // namespace relievo
