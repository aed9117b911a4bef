#pragma once

#include "relief/finish/finish_model.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Gives what lies hidden behind other parts colours of its own, which the drawing does not have:
/// the picture is the drawing with patches (see hidden_patches) below it, texture coordinates are
/// those of the picture, vertices between what is seen and what is hidden are doubled, and nothing
/// counts as hidden any more. The same model where nothing is hidden. Paint goes on around the
/// rim (see extend_paint). Linear in pixels and triangles.
DrawnModel dress_hidden(Model model, Drawing drawing);

/// Carries the paint, or ink, along the outline of a model over its rim: where the paper around
/// blends into the three pixels beside the outline that the model covers, in narrow slivers of it
/// that the outline cut off, and beyond the outline, the picture gets the colours that lie further
/// inside. Surfaces are steep there, so that a fraction of a pixel shows as a broad strip of paper
/// when the model is turned. Texture coordinates are on the whole picture (4 channels). O(pixels).
void extend_paint(const Model& model, Image8& rgba);

}  // namespace relievo::relief
