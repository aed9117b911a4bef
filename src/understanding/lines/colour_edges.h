#pragma once

#include "relievo/image.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {

/// Adds to `map.barrier` the edges between colours where no line runs, and to `map.ink` their
/// strength: ridges of the gradient of the channel that changes most, with hysteresis (Canny 1986).
/// `rgb` is the drawing on white; `map.barrier` holds its lines. O(pixels).
void add_colour_edges(const Image8& rgb, LineMap& map);

/// Adds to `map.barrier` the rim of the opaque areas of a drawing (4 channels) where no line or
/// edge runs, since these may be as white as the page. O(pixels).
void add_alpha_edges(const Image8& rgba, LineMap& map);

}  // namespace relievo::understanding
