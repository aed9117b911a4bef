#pragma once

#include "relievo/bytes.h"
#include "relievo/image.h"

namespace relievo {

/// Returns the orientation, 1 to 8, in an EXIF block: a TIFF directory, after "Exif\0\0" or not.
/// Returns 1 (upright) where it has no valid one.
int exif_orientation(ByteView exif);

/// Returns the image turned and mirrored to be upright, given its EXIF orientation.
Image8 upright(Image8 image, int orientation);

}  // namespace relievo
