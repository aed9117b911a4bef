#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Whether `bytes` begin as a JPEG file does.
bool is_jpeg(ByteView bytes);

/// A JPEG file (grey, colour or CMYK, baseline or progressive) as 8-bit sRGB with alpha 255,
/// 4 channels, upright by its EXIF orientation. Colour profiles are ignored. Errors: `bad_input`
/// where the file is damaged or cut short (the reason is in the message), `limit`.
Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits = {});

/// The orientation, 1 to 8, that an EXIF block ("Exif\0\0" and a TIFF directory) asks for;
/// 1 (upright) where it says nothing valid.
int exif_orientation(ByteView exif);

/// The image turned and mirrored so that it is upright, given its EXIF orientation.
Image8 upright(const Image8& image, int orientation);

}  // namespace relievo
