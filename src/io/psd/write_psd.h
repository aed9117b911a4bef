#pragma once

#include <string>
#include <vector>

#include "relievo/bytes.h"
#include "relievo/image.h"
#include "relievo/result.h"

namespace relievo {

/// A layer of a document.
struct PsdPicture {
  std::string name;  ///< UTF-8
  const Image8* rgba = nullptr;
  int left = 0, top = 0;  ///< px of the canvas, which holds the whole layer
  bool hidden = false;
};

/// A Photoshop document of 8 bits in RGB with layers from the back to the front, packed by
/// PackBits, and the flattened picture of those that are not hidden. Each layer is cut to what is
/// not transparent of it. Errors: `limit` for sides above 30,000 px, the format's own. O(pixels).
Result<Bytes> encode_psd(const std::vector<PsdPicture>& layers, int width, int height);

}  // namespace relievo
