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

/// Fills unknown pixels smoothly from known ones: each takes the colour of the finest mean around
/// it that is known (pull-push; Gortler et al., The Lumigraph, 1996, section 3.4). The last channel
/// of `colours` is the weight in [0, 1]: 0 unknown, 1 known. Returns the other channels, 0 where
/// nothing is known at all. O(values).
ImageF pull_push(const ImageF& colours);

}  // namespace relievo
