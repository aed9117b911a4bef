#pragma once

#include "io/image/image_limits.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Decodes a PNG, JPEG, GIF, WebP, AVIF or HEIC file, recognised by its content, to 8-bit sRGB with
/// straight alpha, 4 channels, upright by its EXIF orientation. Of an animation it is the first
/// frame. Errors: `bad_input` where the file is damaged or none of them, `limit`.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

/// A picture of the size in which parts are sought. At most one of both numbers is not 1.
struct FittedImage {
  Image8 rgba;
  int factor = 1;  ///< the sides were divided by it: each pixel is an average
  int times = 1;   ///< the sides were multiplied by it: each pixel became a square
};

/// Reduces a picture (RGBA) by reduction_factor or enlarges it by `enlargement`.
FittedImage fitted(Image8 rgba);

/// Decodes a picture as decode_image does and fits it, large ones while they are decoded. PNG
/// without interlacing and JPEG without progression are never held whole. Errors: as decode_image.
Result<FittedImage> decode_fitted(ByteView bytes, const ImageLimits& limits = {});

/// Decodes a JPEG file (grey, colour or CMYK, baseline or progressive) to 8-bit sRGB with alpha
/// 255, 4 channels, upright by its EXIF orientation, each pixel the average of `factor` px a side.
/// Colour profiles are ignored. Errors: `bad_input` where the file is damaged or cut short (the
/// message has the reason), `limit`.
Result<Image8> decode_jpeg(ByteView bytes, const ImageLimits& limits = {}, int factor = 1);

}  // namespace relievo
