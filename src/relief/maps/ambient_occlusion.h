#pragma once

#include "relievo/image.h"
#include "relievo/maps.h"

namespace relievo::relief {

/// Computes the share of an even sky's light that each pixel of the front view receives, in [0, 1],
/// 1 on the background: the cosine-weighted share of the hemisphere about its normal that is not
/// occluded by heights within a fifth of the view's longer side, which fade in the outer half.
/// Horizons are sought along eight lines through the pixel and integrated in closed form [Jimenez
/// et al. 2016, Practical real-time strategies for accurate indirect occlusion, eq. 7]. `pixel`:
/// canvas px per pixel of the maps. O(pixels * log of the longer side).
ImageF ambient_occlusion(const ReliefMaps& maps, double pixel);

}  // namespace relievo::relief
