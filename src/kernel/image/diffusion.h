#pragma once

#include "relievo/image.h"

namespace relievo {

/// The weight of a value in `diffuse` that nothing moves.
constexpr float fixed_weight = 1e6F;

/// The smooth function u on the grid that minimises sum w (u - v)^2 + sum (u_i - u_j)^2, over the
/// pixels and over the pairs of neighbours, with no flow across the border of the image. `known`
/// has two channels: v and its weight w >= 0, where 1 / sqrt(w) is how many px a value gives way to
/// those around it. With fixed_weight on both sides of a contour and 0 elsewhere this is the
/// diffusion that an illusory surface follows (D. Geiger, H. Pao, N. Rubin, Salient and multiple
/// illusory surfaces, 1998). By relaxation from coarse to fine, good to about a pixel where it
/// crosses a level. 0 where nothing is known. O(pixels).
ImageF diffuse(const ImageF& known);

}  // namespace relievo
