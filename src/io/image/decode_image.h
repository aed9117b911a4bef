#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "io/image/image_limits.h"
#include "kernel/image/image_size.h"
#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// A PNG, JPEG or GIF file, told apart by its content, as 8-bit sRGB with straight alpha, 4
/// channels. Errors: `bad_input` where it is none of them or damaged, `limit` where it is too
/// large.
Result<Image8> decode_image(ByteView bytes, const ImageLimits& limits = {});

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

/// How every PNG file begins.
constexpr std::array<uint8_t, 8> png_signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Whether `bytes` begin as a PNG file does but for at most three bytes.
bool is_nearly_png(ByteView bytes);

/// What is wrong with the signature of a PNG file that does not begin as one should.
std::string signature_defect(ByteView bytes);

/// What libpng's message says of a file, with the part of the file that it is about. `bytes` have a
/// whole header.
std::string png_defect(ByteView bytes, const std::string& message);

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

/// Whether `bytes` begin as a GIF file does.
bool is_gif(ByteView bytes);

/// The first picture of a GIF file on its canvas as 8-bit sRGB with straight alpha, 4 channels;
/// the canvas around it is transparent. Errors: `bad_input` where the file is damaged or cut short
/// (the reason is in the message), `limit`.
Result<Image8> decode_gif(ByteView bytes, const ImageLimits& limits = {});

}  // namespace relievo
