#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Decodes a PNG, JPEG or GIF file, recognised by its content, to 8-bit sRGB with straight alpha, 4
/// channels. Errors: `bad_input` where it is damaged or none of them, `limit`.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

/// Returns whether `bytes` begin like a JPEG file.
bool is_jpeg(ByteView bytes);

/// Decodes a JPEG file (grey, colour or CMYK, baseline or progressive) to 8-bit sRGB with alpha
/// 255, 4 channels, upright by its EXIF orientation. Colour profiles are ignored. Errors:
/// `bad_input` where the file is damaged or cut short (the message has the reason), `limit`.
Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits = {});

/// Returns the orientation, 1 to 8, in an EXIF block ("Exif\0\0" and a TIFF directory); 1 (upright)
/// where it has no valid one.
int exif_orientation(ByteView exif);

/// Returns the image turned and mirrored to be upright, given its EXIF orientation.
Image8 upright(const Image8& image, int orientation);

/// Returns whether `bytes` begin like a GIF file.
bool is_gif(ByteView bytes);

/// Decodes the first picture of a GIF file on its transparent canvas to 8-bit sRGB with straight
/// alpha, 4 channels. Errors: `bad_input` where the file is damaged or cut short (the message has
/// the reason), `limit`.
Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo
