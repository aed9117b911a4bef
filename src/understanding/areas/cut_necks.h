#pragma once

#include "understanding/areas/basins.h"

namespace relievo::understanding {

/// Divides proposed regions at their necks, where head, limbs, tail and ears of a figure grow out
/// of it without a line. A neck is a chord inside a region, from a concave place of the region's
/// own contour to the nearest other one. What it parts off is longer than the neck, or rounder than
/// the neck is wide, and borders on the background for the most part; the rest is wider beside the
/// neck. Returns whether there are any; then the basins have to be measured again. O(pixels), and
/// the square of contours at a fixed size.
bool cut_necks(Basins& basins);

}  // namespace relievo::understanding
