#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/image/outlines.h"
#include "understanding/completion/contour_gaps.h"
#include "understanding/completion/part_regions.h"

namespace relievo::understanding {

/// A part and what may hide it.
struct HiddenPart {
  const PartRegions& regions;
  int part;
  std::vector<uint8_t> hides;       ///< per part, 1 where it may hide this one
  std::vector<KnownContour> known;  ///< per ring of the part

  const Mask& visible() const { return regions.visible[part]; }
  const std::vector<LabelRing>& rings() const { return regions.rings[part]; }
  bool has_gaps() const;
};

/// How far a contour may be from a shape that explains it, px.
double contour_tolerance(const HiddenPart& hidden);

/// Looks up which sides of the part's rings its occluders may hide. O(sides).
HiddenPart hidden_part(const PartRegions& regions, int part, const std::vector<int>& occluders);

/// The ellipse on which the known contour lies (root mean square at most `tolerance` px) and which
/// contains the hidden one, where there is one. O(sides).
std::optional<Mask> ellipse_shape(const HiddenPart& hidden, double tolerance);

/// The rings with their gaps bridged, where they can be. O(sides + box).
std::optional<Mask> continued_shape(const HiddenPart& hidden);

/// Where the diffusion of the known contour exceeds one half, in a box around the part that is
/// twice as large, and what lies between what is seen: its convex hull. Where contours drift apart,
/// so that the first has no end in that box, it goes on for a quarter of the part's size. O(box).
Mask membrane_shape(const HiddenPart& hidden);

}  // namespace relievo::understanding
