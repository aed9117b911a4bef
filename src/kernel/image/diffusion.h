#pragma once

#include "relievo/image.h"

namespace relievo {

/// The weight of a fixed value in `diffuse`.
constexpr float fixed_weight = 1e6F;

/// Computes the smooth function u on the grid that minimises
///   sum over pixels of w (u - v)^2 + sum over pairs of neighbours of (u_i - u_j)^2,
/// with no flow across the border of the image. `known` has two channels, v and its weight w >= 0;
/// a value yields to those within about 1 / sqrt(w) px. With fixed_weight on both sides of a
/// contour and 0 elsewhere it is the diffusion of an illusory surface (D. Geiger, H. Pao, N. Rubin,
/// Salient and multiple illusory surfaces, 1998). Successive over-relaxation from coarse to fine;
/// level lines are accurate to about a pixel. Returns 0 where nothing is known. O(pixels).
ImageF diffuse(const ImageF& known);

}  // namespace relievo
