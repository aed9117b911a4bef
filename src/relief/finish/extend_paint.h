#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Carries the paint, or ink, along the outline of a model over its rim. The pixels beyond the
/// outline, those beside it that blend with paper, and narrow slivers of paper inside it get the
/// colours further inside: surfaces are steep there, so that a fraction of a pixel shows as a broad
/// strip of paper when the model is turned. The model's texture coordinates are on all of it.
/// Pixel art is extended by whole squares (extend_own_pixels). O(pixels).
void extend_paint(const Model& model, Drawing& drawing);

/// The same for drawings that are no pixel art. `settled`: 1 on pixels that stay.
void extend_paint(const Model& model, const Image8& settled, Image8& rgba);

}  // namespace relievo::relief
