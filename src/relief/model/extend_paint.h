#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo {

/// Carries the paint, or ink, along the outline of a model over its rim: where paper blends into
/// the two pixels beside the outline that the model covers, and beyond them, the picture gets the
/// colours that lie further inside. Surfaces are steep there, so that a fraction of a pixel shows
/// as a broad white strip when the model is turned. Texture coordinates are on the whole picture (4
/// channels). O(pixels).
void extend_paint(const Model& model, Image8& rgba);

}  // namespace relievo
