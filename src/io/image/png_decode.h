#pragma once

#include <string>

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// Whether `bytes` begin as a PNG file does.
bool is_png(ByteView bytes);

/// The size that the header of a PNG file states, without decoding it. Errors as decode_png.
Result<ImageSize> png_size(ByteView bytes, const ImageLimits& limits = {});

/// A PNG file of any colour type, depth and interlacing as 8-bit sRGB with straight alpha,
/// 4 channels. Gamma and colour profiles are ignored, 16-bit samples are rounded. Errors:
/// `bad_input` where the file is damaged or cut short (the reason is in the message), `limit`.
Result<Image8> decode_png(ByteView bytes, const ImageLimits& limits = {});

/// The values themselves of a grey or palette PNG file of up to 16 bits (palette: the indices), not
/// scaled, 1 channel; an alpha channel is left out. For pictures whose values are numbers, not
/// colours. Errors: as decode_png, and `bad_input` where the file holds colours.
Result<Image16> decode_png_values(ByteView bytes, const ImageLimits& limits = {});

/// Whether `bytes` begin as a PNG file does but for at most three bytes.
bool is_nearly_png(ByteView bytes);

/// What is wrong with the signature of a PNG file that does not begin as one should.
std::string signature_defect(ByteView bytes);

/// What libpng's message says of a file, with the part of the file that it is about. `bytes` have a
/// whole header.
std::string png_defect(ByteView bytes, const std::string& message);

}  // namespace relievo
