#pragma once

#include "relievo/image.h"
#include "understanding/lines/line_map.h"

namespace relievo::understanding {

/// Adds to map.barrier the edges between colours that no line marks, and to map.ink how strong
/// they are. `rgb` is the drawing on white; map.barrier holds its lines. O(pixels).
void add_colour_edges(const Image8& rgb, LineMap& map);

}  // namespace relievo::understanding
