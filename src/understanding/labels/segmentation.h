#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"
#include "understanding/perception/perceive.h"

namespace relievo::understanding {

/// Identifies a part: its value in the label image, which it keeps while strokes and corrections
/// change (see relabel). 0 is the background.
using PartLabel = uint16_t;

/// One label of a segmented drawing.
struct SegmentedPart {
  std::string id;
  bool proposed = true;  ///< found in the drawing; false for a part of the scribbles
  int64_t area = 0;      ///< px
  Box2 box;              ///< drawing px
  PartLabel label = 0;
};

/// A closed gap in the lines: a piece of the boundary between two labels without a line.
struct Bridge {
  std::vector<Point2> points;  ///< polyline, drawing px
  PartLabel label_a = 0;       ///< label to its left as seen along it
  PartLabel label_b = 0;       ///< label to its right
};

/// A drawing divided into its visible parts. Labels meet in the middle of lines.
struct Segmentation {
  Image16 labels;                    ///< [drawing size] the part of every pixel, 0 background
  std::vector<SegmentedPart> parts;  ///< those with strokes first
  std::vector<Bridge> bridges;
  FrontMap front;                  ///< see Perception
  std::vector<std::string> notes;  ///< advice for the user, one sentence each
};

}  // namespace relievo::understanding
