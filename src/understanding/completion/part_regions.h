#pragma once

#include <map>
#include <vector>

#include "kernel/image/mask.h"
#include "kernel/image/outlines.h"
#include "relievo/image.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// The parts of a labelled drawing. A part's index is its position in `labels`: that of its label
/// among all labels at first, and the part's index in the scene after sort_regions.
struct PartRegions {
  Image16 map;                                ///< the labels, without the rim of outer ink
  Image16 inked_map;                          ///< the labels with that rim
  std::vector<PartLabel> labels;              ///< per part
  std::vector<int> part_of_label;             ///< per possible label, its part or -1
  std::vector<Mask> visible;                  ///< per part, its pixels in `map`
  std::vector<Mask> inked;                    ///< per part, its pixels in `inked_map`
  std::vector<std::vector<LabelRing>> rings;  ///< per part, its boundaries in `map`

  int count() const { return static_cast<int>(labels.size()); }
  int part_of(PartLabel label) const { return part_of_label[label]; }
  /// The part seen at a pixel of the canvas, or -1.
  int part_at(int x, int y) const { return part_of_label[map.at(x, y)]; }
  /// All parts in ascending order of their labels. O(parts log parts).
  std::vector<int> by_label() const;
};

/// Finds the parts of a label image. Towards the background a rim of this width, px, which is the
/// outer half of their outline's ink, is left out of `map`; parts that are too narrow to have a rim
/// keep all their pixels. O(pixels).
PartRegions find_regions(const Image16& labels, double rim = 0);

/// Moves the parts into the order of these labels, which are all labels. O(parts).
void sort_regions(const std::vector<PartLabel>& order, PartRegions& regions);

/// Counts the pixel sides that a part shares with each part that it touches. O(sides of the part).
std::map<int, int> shared_sides(const PartRegions& regions, int part);

/// Whether a part borders on the background. O(sides of the part).
bool touches_background(const PartRegions& regions, int part);

}  // namespace relievo::understanding
