#pragma once

#include "relievo/image.h"
#include "relievo/maps.h"

namespace relievo::relief {

/// How much of the light of an even sky each pixel of the front view receives, 0 to 1, 1 on the
/// background: the share of the hemisphere about its normal, weighted by the cosine, that the
/// heights within a fifth of the view's longer side leave open; in the outer half they fade.
/// Horizons are sought along eight lines through the pixel and integrated in closed form [Jimenez
/// et al. 2016, Practical real-time strategies for accurate indirect occlusion, eq. 7]. `pixel`:
/// canvas px per pixel of the maps. O(pixels * log of the longer side).
ImageF ambient_occlusion(const ReliefMaps& maps, double pixel);

}  // namespace relievo::relief
