#pragma once

#include "relievo/image.h"

namespace relievo {

/// Largest value within the square of side 2 radius + 1 around each pixel, clipped by the image;
/// each channel by itself. Precondition: radius >= 0. One pass; O(values) along columns, whatever
/// the radius (van Herk 1992; Gil, Werman 1993), and O(values log radius) along rows, which takes
/// less time since it suits vectors.
Image8 max_filter(const Image8& image, int radius);

/// Smallest value within that square.
Image8 min_filter(const Image8& image, int radius);

/// Removes what is darker than its surroundings and narrower than the square.
Image8 close_gaps(const Image8& image, int radius);

/// The mask's pixels, thinned to connected curves of one pixel that keep their ends: 255 on them,
/// 0 elsewhere. `mask` has one channel. O(pixels * widest half width) (Zhang, Suen 1984).
Image8 thin(const Image8& mask);

}  // namespace relievo
