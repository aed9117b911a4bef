#pragma once

#include <cstdint>
#include <vector>

#include "relievo/image.h"
#include "relievo/point.h"

namespace relievo {

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
