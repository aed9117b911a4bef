#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "relievo/image.h"
#include "understanding/labels/segmentation.h"

namespace relievo::understanding {

/// What the pixels of a drawing show about its labels.
struct DrawingEvidence {
  /// Per label from 0, its mean colour, 0 to 255 a channel (see label_colours); empty where
  /// unknown.
  std::vector<std::array<double, 3>> colours;
  /// Pairs of labels, the smaller first, sorted, between which the drawing shows neither a line nor
  /// a change of colour along most of their common border: they have grown together there.
  std::vector<std::pair<PartLabel, PartLabel>> open;
  /// Width, px, of the outer half of the ink that bounds labels towards the background: parts hold
  /// the ink of their outline there, while they meet each other in the middle of lines. Half of the
  /// median width of dark pixels from the background inwards; 0 where there is no such ink.
  double rim = 0;

  /// Pairs of labels, the smaller first, and how far the first is seen in front of the other, from
  /// -1 to 1; empty where unknown.
  std::map<std::pair<PartLabel, PartLabel>, double> front;

  bool is_open(PartLabel a, PartLabel b) const;
  /// Returns `front` of two labels, the smaller first; 0 where unknown.
  double front_of(PartLabel a, PartLabel b) const;
};

/// Measures the evidence. `rgba` has the size of `labels`. O(pixels).
DrawingEvidence measure_evidence(const Image8& rgba, const Image16& labels,
                                 const FrontMap& front = {});

}  // namespace relievo::understanding
