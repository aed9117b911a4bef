#pragma once

#include "relievo/image.h"

namespace relievo {

/// What is known of a pixel before the diffusion.
enum class Cell : uint8_t { zero, one, open };

/// The harmonic function on the grid that is 0 and 1 on the fixed cells, with no flow across the
/// border of the image: the diffusion of a contour's two sides that an illusory surface follows
/// (D. Geiger, H. Pao, N. Rubin, Salient and multiple illusory surfaces, 1998). By relaxation
/// from coarse to fine, good to about a pixel where it crosses one half. O(pixels).
ImageF diffuse_contour(const Image<Cell>& cells);

}  // namespace relievo
