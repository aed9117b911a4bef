#pragma once

#include "relief/drawing/basins.h"

namespace relievo {

/// The figure of a picture on a transparent ground whose opaque areas are it (lines on a
/// transparent ground say nothing), or of paint on paper: what is coloured or dark, the narrow gaps
/// in it and what it surrounds. `rgba` is the drawing, `rgb` the same on white. O(pixels).
FigureMask find_figure(const Image8& rgba, const Image8& rgb, bool painted);

/// Lets nothing of the figure be lost: pixels of it that have no label take the nearest one, or
/// where there is none a new one after `last_label`. Areas that strokes made background stay it.
/// `labels` has those of all pixels, `of_basin` those of basins. O(pixels).
void keep_figure(const Basins& basins, const std::vector<int>& of_basin, int last_label,
                 Image<int32_t>& labels);

}  // namespace relievo
