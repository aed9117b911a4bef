#pragma once

#include "relievo/image.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {

/// Adds to `map.barrier` the edges between colours where no line runs, and to `map.ink` their
/// strength: ridges of the gradient of the channel that changes most, with hysteresis (Canny 1986).
/// `rgb` is the drawing on white; `map.barrier` holds its lines. O(pixels).
void add_colour_edges(const Image8& rgb, LineMap& map);

/// Adds to `map.barrier` as edges the contours that are likelier than `least`, of 255, where no
/// line or edge runs within `margin` px. `contour` has the probabilities, of 255, by pixel.
/// O(pixels).
void add_contours(const Image8& contour, int least, int margin, LineMap& map);

/// Adds to `map.barrier` as edges the opaque pixels of a drawing (RGBA) beside transparent ones,
/// where no line or edge runs within a few px. O(pixels).
void add_cut_edges(const Image8& rgba, LineMap& map);

}  // namespace relievo::understanding
