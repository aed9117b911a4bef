#pragma once

#include <cstdint>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "kernel/image/image.h"

namespace relievo {

/// A corner of pixels, in px from the top left corner of the image.
struct PixelCorner {
  int x = 0;
  int y = 0;
  friend bool operator==(const PixelCorner&, const PixelCorner&) = default;
};

/// A piece of the boundary between two labels, along the sides of pixels, from one corner where
/// three or four sides meet to the next; or a whole closed boundary, whose last corner is its
/// first.
struct LabelArc {
  uint16_t right = 0;  ///< label to the right, going forward
  uint16_t left = 0;
  std::vector<PixelCorner> corners;  ///< one px apart, at least two

  bool closed() const { return corners.front() == corners.back(); }
};

/// All boundaries between different labels (one channel), each once; the image is surrounded by
/// label 0. In raster order of their first corners. O(pixels).
std::vector<LabelArc> trace_label_arcs(const Image16& labels);

/// One use of an arc in a ring: forward or backward.
struct ArcUse {
  int arc = 0;
  bool forward = true;
};

/// The closed boundaries of every label but 0, with the label to the right: [label][ring][use]
/// for labels 0 to the largest. Pixels of a label that meet at a corner only are parted there.
/// O(arcs log arcs).
std::vector<std::vector<std::vector<ArcUse>>> label_rings(const std::vector<LabelArc>& arcs);

}  // namespace relievo
