#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/geometry/polygon.h"
#include "relievo/image.h"

namespace relievo::understanding {

/// One label of a segmented drawing.
struct SegmentedPart {
  std::string id;
  bool proposed = true;  ///< found in the drawing; false for a part of the scribbles
  int64_t area = 0;      ///< px
  Box2 box;              ///< drawing px
};

/// A closed gap in the lines: a piece of the boundary between two labels without a line.
struct Bridge {
  std::vector<Point2> points;  ///< polyline, drawing px
  uint16_t label_a = 0;        ///< label to its left, smaller than label_b
  uint16_t label_b = 0;        ///< label to its right
};

/// A drawing divided into its visible parts. Labels meet in the middle of lines.
struct Segmentation {
  Image16 labels;                    ///< [drawing size] 0 background, k + 1 is parts[k]
  std::vector<SegmentedPart> parts;  ///< in the order of their labels
  std::vector<Bridge> bridges;
  std::vector<std::string> notes;  ///< advice for the user, one sentence each
};

}  // namespace relievo::understanding
