#pragma once

#include <string>
#include <vector>

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Returns whether `bytes` begin like a PNG file.
bool is_png(ByteView bytes);

/// Reads the size in the header of a PNG file, without decoding it. Errors: as decode_png.
Result<ImageSize> png_size(ByteView bytes, const ImageLimits& limits = {});

/// Decodes a PNG file of any colour type, depth and interlacing to 8-bit sRGB with straight alpha,
/// 4 channels, each pixel the average of `factor` px a side. Gamma and colour profiles are ignored,
/// 16-bit samples are rounded. Errors: `bad_input` where the file is damaged or cut short (the
/// message has the reason), `limit`.
Result<Image8> decode_png(ByteView bytes, const ImageLimits& limits = {}, int factor = 1);

/// Decodes the unscaled values of a grey or palette PNG file of up to 16 bits (palette: the
/// indices), 1 channel; an alpha channel is left out. For pictures whose values are numbers, not
/// colours. Errors: as decode_png, and `bad_input` where the file holds colours.
Result<Image16> decode_png_values(ByteView bytes, const ImageLimits& limits = {});

/// Returns whether `bytes` begin like a PNG file but for at most three bytes.
bool is_nearly_png(ByteView bytes);

/// Returns the orientation, 1 to 8, that the EXIF block of a PNG file states; else 1 (upright).
int png_orientation(ByteView bytes);

/// Returns the number of frames that an animated PNG file states; else 1.
size_t png_frame_count(ByteView bytes);

/// A text inside a PNG file. The keyword has 1 to 79 Latin-1 characters.
struct PngText {
  std::string keyword;
  std::string text;
};

/// Encodes an image of 1 (grey), 3 (RGB) or 4 (RGBA, straight alpha) channels as a PNG file. The
/// same pixels always give the same bytes: no time, no gamma, fixed compression. Errors:
/// `bad_input` for an empty image, `internal`.
Result<Bytes> encode_png(const Image8& image, const std::vector<PngText>& texts = {});

/// Likewise a grey image of 16 bits.
Result<Bytes> encode_png(const Image16& image, const std::vector<PngText>& texts = {});

}  // namespace relievo
