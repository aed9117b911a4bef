#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Carries the colours of pixel art over the outline of a model, by whole squares of its own
/// pixels: those that the model covers less than half, and transparent ones, take the colour of
/// about the nearest other. Precondition: drawing.pixel_art > 0. O(pixels).
void extend_own_pixels(const Model& model, Drawing& drawing);

/// Replaces the colours of `filled` (3 channels) by the nearest of those of `seen` whose weight,
/// the fourth channel, is not 0, unless there are more than 256. O(pixels times colours).
void keep_palette(const ImageF& seen, ImageF& filled);

}  // namespace relievo::relief
