#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// The drawing as an opaque texture of the model, RGB at the drawing's resolution. Inside the
/// front view of the model it lies on white paper; outside, and within two pixels of the
/// silhouette, transparent pixels take the colour of the nearest one that is not, so that neither
/// black nor paper fringes the model when the texture is filtered. Empty where the drawing is.
/// Linear in pixels and in faces times their size.
Image8 model_texture(const Model& model, const Drawing& drawing);

}  // namespace relievo::relief
