#pragma once

#include "relievo/image.h"

namespace relievo::understanding {

/// Returns whether a drawing (RGBA) is cut out: more than half of its figure is opaque and more
/// than half of its opaque pixels are figure. `figure` has the probability of the figure by pixel,
/// of 255. Line art on transparency is none, nor is a page that lies on transparency. O(pixels).
bool is_cut_out(const Image8& rgba, const Image8& figure);

/// Gives the opaque pixels of mostly transparent basins to the nearest opaque basin that they are
/// connected with, and the transparent pixels of opaque basins likewise. `basin` has the basin of
/// every pixel, 0 ... count - 1. O(pixels).
void divide_at_cut(const Image8& rgba, int count, Image<int32_t>& basin);

}  // namespace relievo::understanding
