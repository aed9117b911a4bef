#pragma once

#include <cstdint>
#include <vector>

#include "kernel/image/mask.h"
#include "relievo/image.h"

namespace relievo {

/// The neighbours of a pixel: those that share a side with it, or those that share a corner too.
enum class Connectivity { sides, corners };

/// The connected components of a mask.
struct Components {
  Image<int32_t> label;        ///< 0 outside the mask, else 1 .. #C in the order of first pixels
  std::vector<int64_t> areas;  ///< [#C + 1] px; [0] is the area outside the mask
};

/// Labels the connected components of the pixels of `mask` (one channel) that are not 0. O(pixels).
Components connected_components(const Image8& mask, Connectivity connectivity);

/// Returns the pixels of the components k for which chosen[k], [#C + 1], is not 0. O(pixels).
Image8 mask_of_pieces(const Components& pieces, const std::vector<uint8_t>& chosen);

/// Returns for each component 1 where it reaches the picture's edge, else 0, [#C + 1]; [0] is 0.
/// O(edge).
std::vector<uint8_t> pieces_at_edge(const Components& pieces);

/// Returns 1 where `values` (one channel) reach `low` and are connected, over sides and corners, to
/// a pixel that reaches `high`; 0 elsewhere. Precondition: low <= high. O(pixels).
Image8 hysteresis_threshold(const Image8& values, int low, int high);

/// Returns the pixels of `mask` that are connected by sides, within it, to a pixel of `seed`.
/// O(box).
Mask connected_to(const Mask& mask, const Mask& seed);

/// Computes the share of their bounding box that the ones of a mask fill; 0 for an empty mask.
/// O(pixels).
double share_of_box(const Image8& mask);

/// Removes the pieces of a mask that have less than 3 % of the largest piece's area. O(pixels).
Image8 without_small_pieces(const Image8& mask);

/// Fills the holes of a mask: all pixels that it surrounds become 1. O(pixels).
Image8 without_holes(const Image8& mask);

}  // namespace relievo
