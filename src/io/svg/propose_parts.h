#pragma once

#include <string>
#include <vector>

#include "io/svg/svg_drawing.h"
#include "relief/scene/scene.h"

namespace relievo {

/// Parts guessed from the shapes, back to front. Together they cover all that the drawing paints
/// with an alpha of at least one half, except a background. Empty where nothing is drawn.
std::vector<Part> propose_parts(const SvgDrawing& drawing);

}  // namespace relievo
