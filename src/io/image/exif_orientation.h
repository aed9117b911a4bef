#pragma once

#include "relievo/bytes.h"
#include "relievo/image.h"

namespace relievo {

/// The orientation, 1 to 8, that an EXIF block ("Exif\0\0" and a TIFF directory) asks for;
/// 1 (upright) where it says nothing valid.
int exif_orientation(ByteView exif);

/// The image turned and mirrored so that it is upright, given its EXIF orientation.
Image8 upright(const Image8& image, int orientation);

}  // namespace relievo
