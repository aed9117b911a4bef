#pragma once

#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Returns the drawing as an opaque texture of the model, RGB at the drawing's resolution. Inside
/// the front view of the model, transparent pixels are blended with white; outside, and within two
/// pixels of the silhouette, they take the colour of the nearest opaque one, so that neither black
/// nor paper fringes the model when the texture is filtered. Of pixel art, all transparent
/// pixels do, so that the texture has no further colours. Empty if the drawing is. Linear in
/// pixels and in faces times their size.
Image8 model_texture(const Model& model, const Drawing& drawing);

/// As model_texture, but all pixels outside the front view, opaque ones too, take the colour of the
/// nearest inside: so that lines along the silhouette are not fringed by paper.
Image8 outline_texture(const Model& model, const Drawing& drawing);

}  // namespace relievo::relief
