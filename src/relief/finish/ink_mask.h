#pragma once

#include "relief/finish/find_ink.h"
#include "relievo/image.h"
#include "relievo/model.h"

namespace relievo::relief {

/// Returns an image of the drawing, 1 on the pixels of contours and those beside them that blend
/// with them, else 0. Linear in pixels.
Image8 ink_mask(const ContourInk& ink, const Model& model, const Image8& rgba);

}  // namespace relievo::relief
