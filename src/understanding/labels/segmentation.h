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
  bool proposed = true;  ///< found by itself; false where a scribble says so
  int64_t area = 0;      ///< px
  Box2 box;              ///< drawing px
};

/// A gap in the lines that was closed: a piece of the boundary between two labels without a line.
struct Bridge {
  std::vector<Point2> points;  ///< polyline, drawing px
  uint16_t label_a = 0;        ///< to its left as seen along it, smaller than label_b
  uint16_t label_b = 0;        ///< to its right
};

/// A drawing divided into its visible parts. Labels meet on the middle of lines.
struct Segmentation {
  Image16 labels;                    ///< [drawing size] 0 background, k + 1 is parts[k]
  std::vector<SegmentedPart> parts;  ///< in the order of their labels
  std::vector<Bridge> bridges;
  std::vector<std::string> notes;  ///< what a person should know, one sentence each
};

}  // namespace relievo::understanding
