#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/mask.h"
#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo {

struct OutlineOptions {
  int min_sides = 12;      ///< rings with fewer pixel sides are dropped
  double wavelength = 40;  ///< pixel sides: shorter waves of an outline go; 0: none does
  /// Px in x and in y, more than 0, by which an outline moves for that at most; both are less for
  /// what is thin.
  double reach = 1;
  double tolerance = 0.02;  ///< points that are so close to the line between others go, px
};

/// Sub-pixel outline of a mask in canvas px: the fair curve near the middles of its pixel sides,
/// which is smooth like a line by hand and moves no middle by more than `reach`, so that corners
/// stay. Outer rings have positive area, holes negative. The largest ring is kept whatever its
/// size. O(box + boundary * log boundary).
Outline outline_of(const Mask& mask, const OutlineOptions& options = {});

/// The box around the pixels of a mask (one channel) that are not 0, px; empty where there is none.
/// O(pixels).
Box2 box_of(const Image8& mask);

/// The pixels of a width x height canvas whose centres are inside the outline by the non-zero
/// rule. O(points + crossed rows + box).
Mask fill_outline(const Outline& outline, int width, int height);

/// One closed boundary of a label, along pixel sides. The label lies to the right of the
/// direction of travel, so that outer rings run clockwise on the screen and holes against it.
struct LabelRing {
  uint16_t label = 0;
  std::vector<Point2> sides;     ///< middle of every pixel side, canvas px
  std::vector<uint16_t> beyond;  ///< per side, the label across it; 0 outside the image too
  bool hole = false;

  size_t size() const { return sides.size(); }
};

/// The rings of all labels but 0, ordered by their first side in raster order. Labels are
/// 4-connected: where two pixels of a label touch at a corner only, they have separate rings.
/// O(pixels).
std::vector<LabelRing> trace_label_rings(const Image16& labels);

}  // namespace relievo
