#pragma once

#include <map>
#include <vector>

#include "kernel/image/mask.h"
#include "kernel/image/outlines.h"
#include "relievo/image.h"

namespace relievo::understanding {

/// The labels of a drawing as parts. Part k has the k-th smallest label that occurs.
struct PartRegions {
  Image16 map;                                ///< the labels themselves
  std::vector<uint16_t> labels;               ///< per part
  std::vector<int> part_of_label;             ///< per possible label, its part or -1
  std::vector<Mask> visible;                  ///< per part, the pixels of its label
  std::vector<std::vector<LabelRing>> rings;  ///< per part, its boundaries

  int count() const { return static_cast<int>(labels.size()); }
  int part_of(uint16_t label) const { return part_of_label[label]; }
  /// The part seen at a pixel of the canvas, or -1.
  int part_at(int x, int y) const { return part_of_label[map.at(x, y)]; }
};

/// O(pixels).
PartRegions find_regions(const Image16& labels);

/// How many pixel sides a part shares with each part that it touches. O(sides of the part).
std::map<int, int> shared_sides(const PartRegions& regions, int part);

/// Per part, the sorted parts that share at least `min_sides` pixel sides with it.
std::vector<std::vector<int>> neighbours(const PartRegions& regions, int min_sides);

}  // namespace relievo::understanding
