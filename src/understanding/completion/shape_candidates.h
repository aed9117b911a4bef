#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/image/outlines.h"
#include "understanding/completion/contour_gaps.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A part and the parts that may hide it.
struct HiddenPart {
  const PartRegions& regions;
  int part;
  std::vector<uint8_t> hides;       ///< per part, 1 where it may hide this one
  std::vector<KnownContour> known;  ///< per ring of the part

  const Mask& visible() const { return regions.visible[part]; }
  const std::vector<LabelRing>& rings() const { return regions.rings[part]; }
  bool has_gaps() const;
};

/// The largest distance, px, between a contour and a shape that explains it.
double contour_tolerance(const HiddenPart& hidden);

/// Finds the sides of the part's rings that its occluders may hide. O(sides).
HiddenPart hidden_part(const PartRegions& regions, int part, const std::vector<int>& occluders);

/// Fits an ellipse to the known contour that contains the hidden one. Returns nothing where the
/// root mean square distance of the known contour exceeds `tolerance` px. O(sides).
std::optional<Mask> ellipse_shape(const HiddenPart& hidden, double tolerance);

/// Fills the rings with their gaps bridged, where they can be (see bridge_gaps). O(sides + box).
std::optional<Mask> continued_shape(const HiddenPart& hidden);

/// Unites the convex hull of the visible part with the pixels where the diffusion of the known
/// contour exceeds one half, in a box around the part that is twice as large. Where contours drift
/// apart, so that the diffusion's shape has no end in that box, it continues for a quarter of the
/// part's size. O(box).
Mask membrane_shape(const HiddenPart& hidden);

}  // namespace relievo::understanding
