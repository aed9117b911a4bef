#pragma once

#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

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
